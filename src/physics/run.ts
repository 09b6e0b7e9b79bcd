import type { ResolvedExperiment } from './experiment.ts'
import { ExactSum } from './exactSum.ts'
import type { Integrator } from './integrator.ts'
import { integrators } from './integrators/index.ts'
import { entry } from './lists.ts'
import { Motion } from './motion.ts'
import { show } from './problems.ts'
import { Saved } from './saved.ts'
import type { Scene } from './scene.ts'
import { scenes } from './scenes/index.ts'
import { advance } from './step.ts'
import { stoppings } from './stopping/index.ts'
import type { StoppingRule } from './stoppingRule.ts'
import { policyOf } from './timesteps/index.ts'
import type { Advance, FrameContext } from './timestepPolicy.ts'

// What rounding may leave of a difference of energies, in parts of their size: some thousand steps add an ulp each.
const ROUNDING = 4096 * Number.EPSILON

/** How a run stands or ended, and since when on the physics clock [s]. */
export interface Outcome {
  kind: 'moving' | 'at-rest' | 'left-the-track' | 'diverged'
  time: number
}

/**
 * A run of an experiment, one frame at a time: what a game loop calls. `simulate` is a loop around it.
 * Made by `createRun`.
 */
export class Run implements FrameContext {
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
  /** It ended because the timestep policy would have needed more steps than a run may take. */
  abandoned = false
  /** Steps that the timestep policy asked for, but for those that it took back. */
  steps = 0
  readonly order: number
  error = NaN
  allowed = NaN
  /** Who watches a policy that tries steps: told when what was tried is taken back, and when one is kept or refused. */
  watcher: { restored(): void; judged(accepted: boolean): void } | undefined

  private outcomeTime = NaN
  private readonly saved: Saved
  private savedSteps = 0
  private readonly wallClock = new ExactSum()
  private readonly integrator: Integrator
  private readonly rule: StoppingRule
  private readonly policy: Advance
  private readonly advance: typeof advance
  /** Kinetic and potential energy per mass at a state [J/kg], and their sum at the start. */
  private readonly energyAt: (s: number, v: number) => number
  private readonly energy: number

  /** @param step what takes each step: `advance`, or what watches it */
  constructor(experiment: ResolvedExperiment, step = advance) {
    const scene: Scene = entry(scenes, experiment.scene)
    const { parameters } = experiment
    this.integrator = entry(integrators, experiment.integrator)
    this.rule = entry(stoppings, experiment.stopping)
    this.policy = policyOf(experiment.timestep).start()
    this.advance = step
    this.motion = new Motion(
      scene.law(parameters),
      parameters.position!,
      parameters.speed!,
      this.rule.holdsSlip,
    )
    this.energyAt = (s, v) => 0.5 * v * v + scene.potential(parameters, s)
    this.energy = this.energyAt(this.motion.s, this.motion.v)
    this.saved = new Saved(this.motion)
    this.order = Math.min(this.integrator.order, this.integrator.orderWithSpeed)
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

  /** Heat that friction and drag have made [J]. */
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
   * @throws RangeError where it is not, or where the time of the run would no longer be finite
   */
  frame(duration: number): void {
    if (!(typeof duration === 'number' && duration >= 0 && this.time + duration < Infinity))
      throw new RangeError(
        `A frame of ${show(duration)}: a frame lasts a finite number of seconds, 0 or more, and so does the run.`,
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
    const { motion } = this
    if (!motion.moving && this.ended) return
    this.policy(this)
    if (!motion.moving && this.ended) {
      this.stateTime = this.outcomeTime
      this.drawnS = motion.s
    }
  }

  save(): void {
    this.saved.save()
    this.savedSteps = this.steps
  }

  restore(): void {
    this.saved.restore()
    this.steps = this.savedSteps
    this.drawnS = this.motion.s
    this.watcher?.restored()
  }

  judge(accepted: boolean): void {
    this.watcher?.judged(accepted)
  }

  abandon(): void {
    if (this.ended) return
    this.abandoned = true
    this.motion.end('diverged')
    this.outcomeTime = this.stateTime
  }

  step(count = 1, before = 0): void {
    const { motion } = this
    this.steps += count
    for (let i = 0; i < count && motion.moving; i++) {
      this.advance(motion, this.integrator, this.rule)
      if (motion.outcome === 'at-rest' && !this.isPaidRest()) motion.outcome = 'diverged'
      if (!motion.moving)
        this.outcomeTime = this.stateTime + (before + i) * motion.dt + motion.elapsed
    }
    this.drawnS = motion.s
  }

  /**
   * Whether friction can have brought the block to rest: at least half of the energy that is gone has become heat. A
   * method that loses the energy of a swing by itself, in steps too long for it, ends at rest where no block would stop.
   * That is asked where rests are located and the order is 2 or more: elsewhere they are not promised.
   */
  private isPaidRest(): boolean {
    const { motion, rule, order, energy } = this
    if (!rule.keepsOrder || order < 2) return true
    const now = this.energyAt(motion.s, motion.v)
    const rounding = ROUNDING * (Math.abs(energy) + Math.abs(now))
    return energy - now <= (2 * motion.heat) / motion.law.mass + rounding
  }
}
