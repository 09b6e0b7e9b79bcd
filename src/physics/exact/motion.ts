import type { ExactMotion, Parameters } from '../state.ts'
import type { Track } from '../track.ts'
import { exactBelt } from './belt.ts'
import { exactFall } from './fall.ts'
import { exactSpring } from './spring.ts'
import { exactTrack } from './track.ts'

/** The true motion on a track: in closed form with a spring or drag, else piece by piece. */
export function exactOf(track: Track, parameters: Parameters): ExactMotion {
  const { muStatic = 0, muKinetic = 0, stiffness = 0, drag = 0, beltSpeed = 0 } = parameters
  const { angle = 0, gravity, mass, position, speed } = parameters as Record<string, number>
  const start = { gravity: gravity!, mass: mass!, position: position!, speed: speed! }
  if (beltSpeed !== 0) return exactBelt({ ...start, beltSpeed, stiffness, muStatic, muKinetic })
  if (stiffness > 0) return exactSpring({ ...start, angle, stiffness, muStatic, muKinetic })
  if (drag > 0) return exactFall({ ...start, drag })
  return exactTrack(track, { ...start, muStatic, muKinetic })
}
