import { ExactSum } from './exactSum.ts'
import type { Experiment } from './experiment.ts'
import { parseForRun } from './parse.ts'
import { show } from './problems.ts'
import { Run } from './run.ts'

/** A run whose frames come from a game loop. Made by `createRun`. */
export class DrivenRun extends Run {
  private readonly wallClock = new ExactSum()

  /**
   * Advances the run by one frame.
   *
   * @param duration how long the frame lasts [s], finite and not negative; the time scale is applied to it
   * @throws RangeError if it is not, or if the run's time would no longer be finite
   */
  frame(duration: number): void {
    const { timeScale } = this
    if (!(
      typeof duration === 'number' &&
      duration >= 0 &&
      timeScale * (this.time + duration) < Infinity
    ))
      throw new RangeError(
        `A frame of ${show(duration)}: a frame lasts a finite number of seconds, 0 or more, and so does the run.`,
      )
    this.wallClock.add(duration)
    this.time = this.wallClock.value
    this.frameDuration = timeScale * duration
    this.gameTime = timeScale * this.time
    this.advanceFrame()
  }
}

/**
 * A run of an experiment that the caller drives, one `frame(dt)` at a time, as a game loop does. The experiment's
 * `frames` and `duration` are ignored: the caller decides both.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function createRun(experiment: Experiment): DrivenRun {
  return new DrivenRun(parseForRun(experiment))
}
