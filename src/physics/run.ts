import type { ResolvedExperiment } from './experiment.ts'
import { ExactSum } from './exactSum.ts'
import { noteHeat } from './heat.ts'
import { entry } from './lists.ts'
import type { Motion } from './motion.ts'
import type { MotionLog } from './motionLog.ts'
import { Stepper } from './stepper.ts'
import type { Watch } from './stepper.ts'
import { timesteps } from './timesteps/index.ts'
import type { Advance, TimestepPolicy } from './timestepPolicy.ts'

/** How a run stands or ended, and since when on the physics clock [s]. */
export interface Outcome {
  kind: 'moving' | 'at-rest' | 'left-the-track' | 'diverged'
  time: number
}

/**
 * A run of an experiment, one frame at a time: what a game loop calls. `simulate` is a loop around it.
 * Made by `createRun`.
 */
export class Run {
  /** The block: `s` [m] and `v` [m/s] are its state. */
  readonly motion: Motion
  /** Time on the wall clock, the sum of all frames [s]. */
  time = NaN
  /** The time that the physics state stands at [s]. */
  stateTime = NaN
  /** How long the present frame lasts [s]. */
  frameDuration = NaN
  /** The position that the frame shows [m]. */
  drawnS = NaN
  /** Frame time that the timestep policy dropped [s]. */
  lostTime = NaN
  /** Frames so far. */
  frames = 0
  /** Steps that the timestep policy asked for. */
  steps = 0

  /** Each frame is one step, and nothing else: frames may be taken in a row. */
  readonly stepIsFrame: boolean

  private outcomeTime = NaN
  private readonly wallClock = new ExactSum()
  private readonly stepper: Stepper
  private readonly advance: Advance

  constructor(experiment: ResolvedExperiment, watch?: Watch) {
    const timestep: TimestepPolicy = entry(timesteps, experiment.timestep.kind)
    this.advance = timestep.start(experiment.timestep as never)
    this.stepIsFrame = timestep.stepIsFrame === true
    this.stepper = new Stepper(experiment, watch)
    this.motion = this.stepper.motion
    this.drawnS = this.motion.s
    this.time = this.stateTime = this.frameDuration = this.lostTime = this.outcomeTime = 0
  }

  /** How the run stands. Once the block has left the track or diverged, further frames change nothing but the clock. */
  get outcome(): Outcome {
    const kind = this.motion.outcome
    return { kind, time: kind === 'moving' ? this.stateTime : this.outcomeTime }
  }

  /** The block has left the track or diverged: there is nothing left to simulate. */
  get ended(): boolean {
    const { moving, outcome } = this.motion
    return !moving && outcome !== 'at-rest'
  }

  /** Heat that friction has made [J]. */
  get heat(): number {
    return this.motion.heat
  }

  /** How often the acceleration was evaluated. */
  get evaluations(): number {
    return this.motion.evaluations
  }

  /**
   * Moves on by a frame.
   *
   * @param duration how long the frame lasts [s], finite and not negative
   * @throws RangeError where it is not
   */
  frame(duration: number): void {
    if (!(duration >= 0 && duration < Infinity))
      throw new RangeError(
        `A frame of ${String(duration)} s: a frame lasts a finite number of seconds, 0 or more.`,
      )
    this.wallClock.add(duration)
    this.frameDuration = duration
    this.time = this.wallClock.value
    this.advanceFrame()
  }

  /**
   * As `frame`, for a clock that counts for itself and has set `frameDuration` and `time`. They are not passed as
   * arguments, since engines box a number that is.
   */
  advanceFrame(): void {
    this.frames++
    if (this.ended) return
    this.advance(this)
    if (this.ended) {
      this.stateTime = this.outcomeTime
      this.drawnS = this.motion.s
    }
  }

  /**
   * Takes that many steps of `motion.dt` seconds: what a timestep policy calls.
   *
   * @param before of those that `stateTime` does not count yet, how many steps have been taken
   */
  step(count = 1, before = 0): void {
    const { motion } = this
    this.steps += count
    if (!motion.moving) return
    const over = this.stepper.steps(count)
    if (!motion.moving)
      this.outcomeTime = this.stateTime + (before + over) * motion.dt + motion.elapsed
    this.drawnS = motion.s
  }

  /**
   * Where each frame is one step: moves on by a row of frames, that many at the most, as far as none needs the stopping rule.
   * The log says how long they last and takes their states. Returns how many; whoever calls it sets `time` and `stateTime`.
   */
  frameRow(most: number, log: MotionLog): number {
    const { motion } = this
    if (!motion.moving) return 0
    motion.log = log
    motion.dt = log.lengths[0]!
    const taken = this.stepper.row(most)
    motion.log = undefined
    noteHeat(motion, log, taken)
    this.frames += taken
    this.steps += taken
    this.drawnS = motion.s
    return taken
  }
}
