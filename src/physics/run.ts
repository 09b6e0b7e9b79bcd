import { apart } from './apart.ts'
import type { ResolvedExperiment } from './experiment.ts'
import { ExactSum } from './exactSum.ts'
import type { Integrator } from './integrator.ts'
import { entry } from './lists.ts'
import { integrators } from './integrators/index.ts'
import { Motion } from './motion.ts'
import type { MotionLog } from './motionLog.ts'
import type { Law } from './law.ts'
import { scenes } from './scenes/index.ts'
import { stoppings } from './stopping/index.ts'
import type { StoppingRule } from './stoppingRule.ts'
import { timesteps } from './timesteps/index.ts'
import type { Advance, TimestepPolicy } from './timestepPolicy.ts'
import type { Scene } from './scene.ts'

// Few enough that an integrator is called often: an engine that has to replace the code of a loop while it runs makes worse code
// of it, which boxes every number that the loop carries.
const LONGEST_ROW = 64

/** How a run stands or ended, and since when on the physics clock [s]. */
export interface Outcome {
  kind: 'moving' | 'at-rest' | 'left-the-track' | 'diverged'
  time: number
}

/** Puts itself between a run and the parts it is made of, to see what passes; must change nothing. */
export interface Watch {
  law(law: Law): Law
  integrator(integrator: Integrator): Integrator
  stopping(rule: StoppingRule): StoppingRule
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

  private outcomeTime = NaN
  private readonly stepIsFrame: boolean
  private readonly wallClock = new ExactSum()
  /** What begins a row of steps, and what takes them. */
  private readonly parts: ((motion: Motion) => void)[]
  private readonly integrator: Integrator
  private readonly stopping: StoppingRule
  private readonly advance: Advance

  constructor(experiment: ResolvedExperiment, watch?: Watch) {
    const scene: Scene = entry(scenes, experiment.scene)
    const { parameters } = experiment
    const integrator: Integrator = entry(integrators, experiment.integrator)
    const stopping: StoppingRule = entry(stoppings, experiment.stopping)
    this.integrator = watch ? watch.integrator(integrator) : setApart(integrator)
    this.stopping = watch ? watch.stopping(stopping) : stopping
    const timestep: TimestepPolicy = entry(timesteps, experiment.timestep.kind)
    this.advance = timestep.start(experiment.timestep as never)
    const law = scene.law(parameters)
    this.motion = new Motion(watch ? watch.law(law) : law, parameters.position!, parameters.speed!)
    this.motion.accurate = integrator.order > 2
    this.motion.holdSlip(this.stopping.holdsSlip)
    this.parts = [watch ? startNone : startRow, integrator.step]
    this.stepIsFrame = timestep.stepIsFrame === true
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
   * Takes that many steps of `motion.dt` seconds: what a timestep policy calls. Steps in which nothing happens are taken in
   * a row by the integrator alone; one that meets a stop or a joint is the stopping rule's.
   *
   * @param before of those that `stateTime` does not count yet, how many steps have been taken
   */
  step(count = 1, before = 0): void {
    const { motion } = this
    this.steps += count
    if (!motion.moving) return
    let left = count
    while (left > 0 && motion.moving) {
      left -= this.row(left)
      if (left === 0) break
      this.stopping.advance(motion, this.integrator)
      if (!motion.moving)
        this.outcomeTime = this.stateTime + (before + count - left) * motion.dt + motion.elapsed
      left--
    }
    this.drawnS = motion.s
  }

  /**
   * Where each frame is one step: moves on by a row of frames of `frameDuration`, that many at the most, as far as none needs
   * the stopping rule. Returns how many; their states are noted in the log. Whoever calls it sets `time` and `stateTime`.
   */
  frameRow(most: number, log: MotionLog): number {
    const { motion } = this
    if (!this.stepIsFrame || !motion.moving) return 0
    const asked = Math.min(most, LONGEST_ROW)
    log.end = log.rows + asked
    motion.dt = this.frameDuration
    motion.log = log
    const taken = this.row(asked)
    motion.log = undefined
    this.frames += taken
    this.steps += taken
    this.drawnS = motion.s
    return taken
  }

  /** Takes steps in a row by the integrator alone, that many at the most, until one needs the stopping rule. Returns how many. */
  private row(most: number): number {
    const { motion } = this
    let left = most
    while (left > 0) {
      const asked = left < LONGEST_ROW ? left : LONGEST_ROW
      motion.left = asked
      const ready = motion.inRow && motion.dt > 0
      // From a list, since a function that an engine knows to be always the same it would compile in after all.
      apart(this.parts[ready ? 1 : 0]!, motion)
      if (ready) {
        left -= asked - motion.left
        if (motion.left === 0) continue
        motion.refuse()
      }
      if (!motion.inRow) break
    }
    motion.left = 0
    return most - left
  }
}

function startRow(motion: Motion): void {
  motion.startRow()
}

/** Whoever watches wants to see each step by itself. */
function startNone(motion: Motion): void {
  motion.inRow = false
}

/** The same integrator, its steps compiled by themselves. */
function setApart(integrator: Integrator): Integrator {
  // From a list, since a function that an engine knows to be always the same it would compile in after all.
  const steps = [integrator.step]
  return {
    ...integrator,
    step: (motion) => {
      apart(steps[0]!, motion)
    },
  }
}
