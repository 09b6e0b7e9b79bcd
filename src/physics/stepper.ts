import { apart } from './apart.ts'
import type { ResolvedExperiment } from './experiment.ts'
import type { Integrator } from './integrator.ts'
import { integrators } from './integrators/index.ts'
import type { Law } from './law.ts'
import { entry } from './lists.ts'
import { Motion } from './motion.ts'
import { enterPiece } from './piece.ts'
import { refuse, startRow } from './row.ts'
import type { Scene } from './scene.ts'
import { scenes } from './scenes/index.ts'
import { stoppings } from './stopping/index.ts'
import type { StoppingRule } from './stoppingRule.ts'

// An engine that has to replace the code of a loop while it runs makes worse code of it, which boxes every number that the
// loop carries: an integrator is called anew after so many steps.
const LONGEST_ROW = 1024

/** Puts itself between a run and the parts it is made of, to see what passes; must change nothing. */
export interface Watch {
  law(law: Law): Law
  integrator(integrator: Integrator): Integrator
  stopping(rule: StoppingRule): StoppingRule
}

/** Takes the steps of a motion: those in which nothing happens by the integrator alone, the others by the stopping rule. */
export class Stepper {
  readonly motion: Motion
  private readonly integrator: Integrator
  private readonly stopping: StoppingRule
  /** What begins a row of steps, and what takes them. */
  private readonly parts: ((motion: Motion) => void)[]
  /** Evaluations of the acceleration in a step, and in one more before the first where none is known. */
  private readonly each: number
  private readonly first: number

  constructor(experiment: ResolvedExperiment, watch?: Watch) {
    const scene: Scene = entry(scenes, experiment.scene)
    const { position, speed } = experiment.parameters
    const integrator: Integrator = entry(integrators, experiment.integrator)
    const stopping: StoppingRule = entry(stoppings, experiment.stopping)
    const law = scene.law(experiment.parameters)
    const motion = new Motion(watch ? watch.law(law) : law, position!, speed!)
    this.motion = motion
    motion.accurate = integrator.order > 2
    motion.slipHeld = stopping.holdsSlip
    motion.reusable = !law.dependsOnSpeed && (motion.slipHeld || law.muKinetic === 0) ? 1 : 0
    enterPiece(motion)
    const { least, most } = integrator.evaluations
    this.each = integrator.counts ? 0 : motion.reusable === 1 ? least : most
    this.first = motion.reusable === 1 && least < most && !integrator.counts ? 1 : 0
    // From a list, since a function that an engine knows to be always the same it would compile in after all.
    this.parts = [watch ? startNone : startRow, integrator.step]
    const apartFromIt = { ...integrator, step: () => this.take(1) }
    this.integrator = watch ? watch.integrator(apartFromIt) : apartFromIt
    this.stopping = watch ? watch.stopping(stopping) : stopping
  }

  /** Takes that many steps of `motion.dt` seconds. Returns how many of them were over before the motion ended. */
  steps(count: number): number {
    const { motion } = this
    let left = count
    while (left > 0) {
      const taken = this.row(left)
      left -= taken
      if (taken > 0) continue
      this.stopping.advance(motion, this.integrator)
      if (!motion.moving) break
      left--
    }
    return count - left
  }

  /** Takes steps in a row by the integrator alone, that many at the most, until one needs the stopping rule. Returns how many. */
  row(most: number): number {
    const { motion } = this
    const asked = most < LONGEST_ROW ? most : LONGEST_ROW
    motion.asked = asked
    // One step that follows others needs no new look.
    if (asked > 1 || motion.inRow === 0 || motion.dt === 0) apart(this.parts[0]!, motion)
    const taken = motion.inRow === 1 ? this.take(asked) : 0
    motion.asked = motion.taken = motion.free = 0
    return taken
  }

  /** Has the integrator take steps, and counts its evaluations. Returns how many it took of a row. */
  private take(asked: number): number {
    const { motion } = this
    const { known } = motion
    apart(this.parts[1]!, motion)
    const taken = motion.asked > 0 ? motion.taken : 1
    if (taken < asked) refuse(motion)
    if (taken > 0) {
      motion.known = motion.reusable
      motion.evaluations += taken * this.each + (known === 1 ? 0 : this.first)
    }
    motion.keptEvaluations = motion.evaluations
    return taken
  }
}

/** Whoever watches wants to see each step by itself. */
function startNone(motion: Motion): void {
  motion.inRow = 0
}
