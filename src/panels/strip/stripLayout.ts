import type { SimulatedRunner } from '../../lab/state/simulation.ts'
import { clockworkOf, noteOf } from './stripLanes.ts'

/** The line under a lane that says what is odd about its time [px]. */
const NOTE = 17

/** How high a lane is, and where its note stands [px]. */
interface Lane {
  readonly top: number
  readonly frames: number
  readonly steps: number
  readonly note: number
}

/** Where each runner's lane stands, with or without room for notes. */
export function layOutLanes(runners: readonly SimulatedRunner[], noted: boolean) {
  const plain = Math.max(8, 32 / runners.length)
  let height = 0
  const boxes = runners.map((runner): Lane => {
    const top = height
    const stepping = clockworkOf(runner.trajectory).step !== undefined
    const frames = stepping ? 10 : plain
    const steps = stepping ? 13 : 0
    const note = top + frames + steps
    height = note + (noted && hasNote(runner) ? NOTE : 0)
    return { top, frames, steps, note }
  })
  return { boxes, height: Math.max(height, 8) }
}

/** Whether there is something to say of a runner's time, at every instant or at none. */
export function hasNote(runner: SimulatedRunner): boolean {
  return noteOf(runner, 0) !== ''
}
