import type { Experiment } from './experiment.ts'
import { FrameLoop } from './frameLoop.ts'
import type { Integrator } from './integrator.ts'
import { feltOn } from './law.ts'
import type { Contact, Law } from './law.ts'
import type { Motion } from './motion.ts'
import { parseExperiment } from './parse.ts'
import type { Watch } from './stepper.ts'
import type { State } from './scene.ts'
import type { StoppingRule } from './stoppingRule.ts'

/** One look at the forces: where, and what they were per mass [m/s²]. */
export interface Evaluation extends State {
  drive: number
  press: number
  /** dv/dt there: drive − slip μk press. */
  a: number
}

/** One step of the integrator as it was taken, kept or not. */
export interface TriedStep {
  /** Its length [s]. */
  dt: number
  from: State
  to: State
  /** The slip direction that was held, 0 where it followed the sign of each v. */
  slip: -1 | 0 | 1
  /** The acceleration at `from`, where it was known from the step before and served again [m/s²]. */
  reused: number | undefined
  /** One that was reused is not among them. */
  evaluations: Evaluation[]
}

/** A stretch without a jump of the law: the tries to find its end, of which the last was kept. */
export interface Stretch {
  /** When it begins, in the step that the policy asked for [s]. */
  begins: number
  tries: TriedStep[]
  /** What ended it, if not the step's end. */
  jump?: 'stop' | 'joint'
}

/** A look at a block with v = 0, whether static friction holds it; `a` is the drive that it has to hold against. */
export interface Standing extends Evaluation {
  /** When, in the step that the policy asked for [s]. */
  begins: number
}

/** A step that the timestep policy asked for. */
export interface PolicyStep {
  dt: number
  from: State
  to: State
  stretches: Stretch[]
  /** Of these the last one held where the outcome is at rest; after each of the others the block set off. */
  standings: Standing[]
  outcome: Motion['outcome']
}

/**
 * The steps inside one frame of an experiment, as they ran: the run is played again up to the frame with somebody
 * watching, through the same code and to the same bits as `simulate`.
 *
 * @param frame the row of the trajectory that the frame ends at, 1 or more
 * @throws ExperimentError for an experiment that can't be run, RangeError for a frame that it does not have
 */
export function traceFrame(experiment: Experiment, frame: number): PolicyStep[] {
  const watcher = new Watcher()
  const loop = new FrameLoop(parseExperiment(experiment), watcher)
  for (let i = 1; i <= frame && loop.goesOn; i++) {
    watcher.writes = i === frame
    loop.next()
  }
  if (!watcher.writes)
    throw new RangeError(
      `The run has no frame ${String(frame)}; its frames are 1 to ${loop.run.frames}.`,
    )
  return watcher.steps
}

class Watcher implements Watch {
  writes = false
  readonly steps: PolicyStep[] = []
  private evaluations: Evaluation[] | undefined
  /** The one in a step that is watched. */
  private motion: Motion | undefined

  law(law: Law): Law {
    const forces = law.forces.map((each) => {
      const felt = feltOn(each)
      return (contact: Contact) => {
        felt(contact)
        this.seen(contact)
      }
    })
    return { ...law, forces }
  }

  private seen({ s, v, drive, press }: Contact): void {
    if (this.evaluations) this.evaluations.push({ s, v, drive, press, a: NaN })
    // Only static friction asks about a block that slides to neither side.
    else if (this.motion?.slipHeld && this.motion.slip === 0)
      this.steps[this.steps.length - 1]!.standings.push({
        ...{ s, v, drive, press, a: drive },
        begins: this.motion.elapsed,
      })
  }

  integrator(integrator: Integrator): Integrator {
    return {
      ...integrator,
      step: (motion) => {
        if (this.writes) this.tryStep(motion, integrator)
        else integrator.step(motion)
      },
    }
  }

  stopping(rule: StoppingRule): StoppingRule {
    return {
      ...rule,
      advance: (motion, integrator) => {
        if (this.writes) this.advance(motion, integrator, rule)
        else rule.advance(motion, integrator)
      },
    }
  }

  private advance(motion: Motion, integrator: Integrator, rule: StoppingRule): void {
    const step: PolicyStep = {
      dt: motion.dt,
      from: stateOf(motion),
      to: stateOf(motion),
      stretches: [],
      standings: [],
      outcome: 'moving',
    }
    this.steps.push(step)
    this.motion = motion
    rule.advance(motion, integrator)
    this.motion = undefined
    step.to = stateOf(motion)
    step.outcome = motion.outcome
    const { stretches } = step
    stretches.forEach((stretch, i) => {
      const after = stretches[i + 1]?.tries[0]!.from ?? step.to
      if (after.v === 0) stretch.jump = 'stop'
      else if (motion.law.joints.includes(after.s)) stretch.jump = 'joint'
    })
  }

  private tryStep(motion: Motion, integrator: Integrator): void {
    const { stretches } = this.steps[this.steps.length - 1]!
    const begins = motion.elapsed
    const slip = motion.slipHeld ? motion.slip : 0
    const tried: TriedStep = {
      dt: motion.dt,
      from: stateOf(motion),
      to: stateOf(motion),
      slip,
      // Only a method that uses it again leaves one.
      reused: motion.known === 1 && !Number.isNaN(motion.a) ? motion.a : undefined,
      evaluations: [],
    }
    this.evaluations = tried.evaluations
    integrator.step(motion)
    this.evaluations = undefined
    tried.to = stateOf(motion)
    for (const each of tried.evaluations) {
      const direction = motion.slipHeld ? slip : Math.sign(each.v)
      each.a = each.drive - direction * motion.law.muKinetic * each.press
    }
    const current = stretches[stretches.length - 1]
    // Tries of the same stretch begin at the same instant, and a stretch takes time.
    if (current?.begins === begins) current.tries.push(tried)
    else stretches.push({ begins, tries: [tried] })
  }
}

function stateOf({ s, v }: Motion): State {
  return { s, v }
}
