import type { ResolvedExperiment } from './experiment.ts'
import type { Integrator } from './integrator.ts'
import { integrators } from './integrators/index.ts'
import { entry } from './lists.ts'
import { Motion } from './motion.ts'
import { Saved } from './saved.ts'
import type { Scene } from './scene.ts'
import { scenes } from './scenes/index.ts'
import { advance } from './step.ts'
import { stoppings } from './stopping/index.ts'
import type { StoppingRule } from './stoppingRule.ts'
import { policyOf } from './timesteps/index.ts'
import type { Advance, FrameContext } from './timestepPolicy.ts'

// The relative rounding error of a difference of energies: some thousand steps add an ulp each.
const ROUNDING = 4096 * Number.EPSILON

/** How a run has ended, or that it is still moving; and since when, on the physics clock [s]. */
export interface Outcome {
  kind: 'moving' | 'at-rest' | 'left-the-track' | 'diverged'
  time: number
}

/**
 * A run of an experiment, one frame at a time: `simulate` is a loop around it, and a game loop calls it as a
 * `DrivenRun`.
 */
export class Run implements FrameContext {
  /** The block: `s` [m] and `v` [m/s] are its state. */
  readonly motion: Motion
  /** Time on the wall clock, the sum of all frames [s]. */
  time = NaN
  /** The game's time: that of the wall clock as the game measures it, times the time scale [s]. */
  gameTime = NaN
  /** The time that the physics state stands at [s]. */
  stateTime = NaN
  /** By how much the present frame moves the game's time [s]. */
  frameDuration = NaN
  /** How fast the game's time goes: 0.1 is slow motion. */
  readonly timeScale: number
  /** The position that the frame shows [m]. */
  drawnS = NaN
  /** Frame time that the timestep policy dropped [s]. */
  lostTime = NaN
  /** Frames so far. */
  frames = 0
  /** The run ended because the timestep policy needed more steps than a run may take. */
  abandoned = false
  /** Steps that the timestep policy asked for, without those that it took back. */
  steps = 0
  readonly order: number
  tried = NaN
  error = NaN
  allowed = NaN
  /** Observes a policy that tries steps: called when a try is taken back, and when one is accepted or rejected. */
  watcher: { restored(): void; judged(accepted: boolean): void } | undefined

  private outcomeTime = NaN
  private readonly saved: Saved
  private savedSteps = 0
  private readonly integrator: Integrator
  private readonly rule: StoppingRule
  private readonly policy: Advance
  private readonly advance: typeof advance
  /** Kinetic and potential energy per mass at a state [J/kg], and their sum at the start. */
  private readonly energyAt: (s: number, v: number) => number
  private readonly energy: number

  /** @param step takes each step: `advance`, or a function that observes it */
  constructor(experiment: ResolvedExperiment, step = advance) {
    const scene: Scene = entry(scenes, experiment.scene)
    const { parameters } = experiment
    this.integrator = entry(integrators, experiment.integrator)
    this.rule = entry(stoppings, experiment.stopping)
    this.timeScale = experiment.timeScale
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
    this.time = this.gameTime = this.stateTime = this.frameDuration = 0
    this.lostTime = this.outcomeTime = 0
  }

  /** The outcome so far. Once the block has left the track or diverged, further frames change only the clock. */
  get outcome(): Outcome {
    const kind = this.motion.outcome
    return { kind, time: kind === 'moving' ? this.stateTime : this.outcomeTime }
  }

  /** The block has left the track or diverged: there is nothing left to simulate. */
  get ended(): boolean {
    const { moving, outcome } = this.motion
    return !moving && outcome !== 'at-rest'
  }

  /** Heat from friction and drag [J]. */
  get heat(): number {
    return this.motion.heat
  }

  /** How often the acceleration was evaluated. */
  get evaluations(): number {
    return this.motion.evaluations
  }

  /**
   * Advances the run by one frame, whose `time`, `frameDuration` and `gameTime` the caller has set. They are not passed as
   * arguments, since engines box number arguments.
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
      this.checkOutcome()
      if (!motion.moving)
        this.outcomeTime = this.stateTime + (before + i) * motion.dt + motion.elapsed
    }
    this.drawnS = motion.s
  }

  stepToEvent(): void {
    const { motion } = this
    this.steps++
    this.advance(motion, this.integrator, this.rule, true)
    this.checkOutcome()
    if (!motion.moving) this.outcomeTime = this.stateTime + motion.elapsed
    this.drawnS = motion.s
  }

  private checkOutcome(): void {
    const { motion } = this
    if (motion.outcome === 'at-rest' && !this.isPaidRest()) motion.outcome = 'diverged'
  }

  /**
   * Whether friction can have brought the block to rest: at least half of the lost energy has become heat. A
   * method whose steps are too long for a swing can damp it by itself, and come to rest where no real block would.
   * Checked only for located stops and order 2 or more: in other cases no rest is promised.
   */
  private isPaidRest(): boolean {
    const { motion, rule, order, energy } = this
    if (!rule.keepsOrder || order < 2) return true
    const now = this.energyAt(motion.s, motion.v)
    const rounding = ROUNDING * (Math.abs(energy) + Math.abs(now))
    return energy - now <= (2 * motion.heat) / motion.law.mass + rounding
  }
}
