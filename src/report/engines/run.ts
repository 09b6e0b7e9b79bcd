import { sizeText } from '../../chart/magnitudes.ts'
import { plain } from '../../chart/numbers.ts'
import { simulate } from '../../physics/index.ts'
import type { Experiment, FramesChoice } from '../../physics/index.ts'
import type { EngineRun, EngineScene } from '../schema/index.ts'
import { settled } from './engine.ts'
import type { EngineBlock, EngineSlope } from './engine.ts'

type Outcome = Omit<EngineRun, 'engine' | 'scene' | 'clock'>

/** Runs an engine's block through a scene, a step a frame, as a game would. */
export function runEngine(
  make: (slope: EngineSlope) => EngineBlock,
  scene: EngineScene,
  frames: FramesChoice,
): Outcome {
  const { angle, muKinetic, gravity, speed } = scene.parameters
  const block = settled(make, { angle: angle!, friction: muKinetic!, gravity: gravity! })
  const start = block.along()
  const gap = block.above()
  if (speed !== 0) block.push(speed!)
  const run = (duration: number) => {
    for (const frame of durations(frames, duration)) block.step(frame)
    return block.along() - start
  }
  // The last tenth apart, to see whether it still moves.
  const late = run(0.9 * scene.duration)
  const position = run(0.1 * scene.duration)
  const lifted = block.above() - gap
  const { watchedUntil } = scene
  const later = watchedUntil === null ? null : run(watchedUntil - scene.duration)
  block.free()
  return outcome(scene, { position, late, lifted, later })
}

/** The same with our own step. */
export function runOurs(
  method: Partial<Experiment>,
  scene: EngineScene,
  frames: FramesChoice,
): Outcome {
  const at = (duration: number) => {
    const { s } = simulate({
      scene: 'ramp',
      parameters: scene.parameters,
      frames,
      duration,
      ...method,
    })
    return s[s.length - 1]!
  }
  const { watchedUntil, duration } = scene
  return outcome(scene, {
    position: at(duration),
    late: at(0.9 * duration),
    lifted: 0,
    later: watchedUntil === null ? null : at(watchedUntil),
  })
}

/**
 * What was seen of a run: positions [m] at the end, at nine tenths of it and after being watched; how far off the
 * slope.
 */
export interface Seen {
  readonly position: number
  readonly late: number
  readonly lifted: number
  readonly later: number | null
}

function outcome(scene: EngineScene, seen: Seen): Outcome {
  const { position, later } = seen
  const finite = Number.isFinite(position)
  return {
    position: finite ? position : null,
    error: finite ? Math.abs(position - scene.truth) : null,
    creep: later === null || !finite ? null : later - position,
    note: notes(scene, seen),
  }
}

/** How long the frames of a clock last, up to `duration` [s]. */
function durations(frames: FramesChoice, duration: number): number[] {
  const { time } = simulate({ scene: 'ramp', frames, duration })
  return Array.from(time.subarray(1), (end, row) => end - time[row]!)
}

/** What stays within this is at rest: a hundred times what single precision makes of a block 10 m away [m]. */
const STILL = 1e-4

/** A run's anomaly, in words; null if there is none. */
export function notes(scene: EngineScene, { position, late, lifted, later }: Seen): string | null {
  if (!Number.isFinite(position)) return 'ended as no number'
  const said: string[] = []
  if (Math.abs(lifted) > 0.1) said.push(`${sizeText(Math.abs(lifted))} off the slope`)
  const moves = Math.abs(position - late) > STILL
  if (scene.rests && moves)
    said.push(
      `still moves: ${sizeText(Math.abs(position - late))} in the last ${plain(0.1 * scene.duration)}\u202fs`,
    )
  if (!scene.rests && !moves)
    said.push(`at rest at ${sizeText(Math.abs(position))}, where nothing holds it`)
  if (scene.rests && !moves && later !== null && Math.abs(later - position) > STILL)
    said.push(`creeps ${sizeText(Math.abs(later - position))} while it should rest`)
  return said.length > 0 ? said.join('; ') : null
}
