import type { PolicyStep, Trajectory } from '../../physics/index.ts'
import { count, say } from './said.ts'
import type { Said } from './said.ts'

/** How long the frame lasts that ends at a row [s]. */
export function frameLength({ time }: Trajectory, row: number): number {
  return rounded(time[row]! - time[row - 1]!)
}

/** A difference of times [s] without what rounding left in its last digits. */
function rounded(time: number): number {
  return Math.round(time * 1e12) / 1e12
}

/** How the timestep policy turned a frame into steps, where `steps` are those that had something to move. */
export function policyWords(run: Trajectory, row: number, steps: readonly PolicyStep[]): Said {
  const { experiment, outcome } = run
  const { timestep } = experiment
  const lasts = frameLength(run, row)
  const ends = outcome.kind !== 'moving' && outcome.kind !== 'at-rest' && row === run.frames
  if (ends && steps.length > 0)
    return say`${count(steps.length, 'step')} of ${steps[0]!.dt} s, until the run ended.`
  switch (timestep.kind) {
    case 'per-frame':
      return say`One step of ${timestep.step} s, however long the frame was.`
    case 'variable':
      return say`One step, as long as the frame: ${lasts} s.`
    case 'capped':
      return lasts > timestep.cap
        ? say`One step of ${timestep.cap} s, the cap: the other ${rounded(lasts - timestep.cap)} s of the frame is lost.`
        : say`One step, as long as the frame: ${lasts} s is within the cap of ${timestep.cap} s.`
    case 'substeps': {
      const length = steps[0]?.dt
      if (length === undefined)
        return say`Equal parts of the frame, none longer than ${timestep.step} s.`
      const parts = count(Math.round(lasts / length), 'equal part')
      return say`${lasts} s → ${parts} of ${length} s, none longer than ${timestep.step} s.`
    }
    case 'fixed':
      return fixedWords(run, row, timestep.step)
  }
}

/** The accumulator holds the time by which the wall clock is ahead, without the whole steps that were dropped. */
function fixedWords(run: Trajectory, row: number, step: number): Said {
  const { time, stateTime } = run
  const [before, after] = [row - 1, row].map((at) => {
    const ahead = time[at]! - stateTime[at]!
    const dropped = Math.floor(ahead / step + 1e-9)
    return { dropped, left: rounded(ahead - dropped * step) }
  }) as [Accumulator, Accumulator]
  const taken = Math.round((stateTime[row]! - stateTime[row - 1]!) / step)
  const lost = after.dropped - before.dropped
  const steps = count(taken, 'fixed step')
  return [
    ...say`${before.left} s in the accumulator + ${frameLength(run, row)} s → ${steps} of ${step} s, `,
    ...say`${after.left} s left in the accumulator.`,
    ...(lost > 0
      ? say` ${count(lost, 'step')} more would have been due: ${rounded(lost * step)} s is lost.`
      : []),
  ]
}

interface Accumulator {
  readonly dropped: number
  /** [s] */
  readonly left: number
}
