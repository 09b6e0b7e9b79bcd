import type { Parameters } from './state.ts'
import type { Track } from './track.ts'

/** Beyond any valid motion: 1e9 m away, 1e9 m/s and 1e6 m/s² for 1e6 s stay below it [m, m/s]. */
export const FAR = 1e24
const FAST = 1e15

/** The constants of a scene's law of motion: `Motion.acceleration` is the law itself. */
export interface Law {
  readonly track: Track
  /** [m/s²] */
  readonly gravity: number
  /** [kg] */
  readonly mass: number
  /** Coefficients of static and kinetic friction, μs ≥ μk. */
  readonly muStatic: number
  readonly muKinetic: number
  /** The spring's stiffness per mass, k/m [1/s²]. */
  readonly stiffness: number
  /** Air drag per mass, c/m [1/m]. */
  readonly drag: number
  /** The track's own speed along s, u: 0 except on a belt [m/s]. */
  readonly belt: number
  /** Friction or drag acts, so that the force or its derivative jumps at a turn. */
  readonly turnMatters: boolean
  /** Only a step that has lost its stability exceeds this speed [m/s]. */
  readonly speedLimit: number
}

/** The law for a scene's parameters. A force that the scene lacks is 0. */
export function lawOf(track: Track, parameters: Parameters): Law {
  const { gravity = 0, mass = 1, muStatic = 0, muKinetic = 0, beltSpeed: belt = 0 } = parameters
  const stiffness = (parameters.stiffness ?? 0) / mass
  const drag = (parameters.drag ?? 0) / mass
  return {
    ...{ track, gravity, mass, muStatic, muKinetic, stiffness, drag, belt },
    turnMatters: muStatic > 0 || drag > 0,
    speedLimit: stiffness > 0 ? fastestOnSpring(track, stiffness, parameters) : FAST,
  }
}

/**
 * A thousand times the highest possible speed of a block on a spring, so a million times the energy [m/s]: that of its
 * swing about the point of balance, its starting speed, and on a belt what the belt adds. The parts are added as
 * if they never cancelled or squared, so that no rounding and no underflow makes it too small for the motion.
 */
function fastestOnSpring(track: Track, stiffness: number, parameters: Parameters): number {
  const { gravity = 0, position = 0, speed = 0, beltSpeed = 0, muStatic = 0 } = parameters
  const omega = Math.sqrt(stiffness)
  const balance = (gravity * track[0]!.sin) / omega
  const carried = beltSpeed === 0 ? 0 : Math.abs(beltSpeed) + (2 * muStatic * gravity) / omega
  return 1000 * (Math.abs(omega * position) + balance + Math.abs(speed) + carried)
}
