import type { Experiment } from './experiment.ts'
import { FrameLoop } from './frameLoop.ts'
import type { Integrator } from './integrator.ts'
import type { Motion } from './motion.ts'
import { parseExperiment } from './parse.ts'
import type { State } from './state.ts'
import { advance } from './step.ts'
import type { StoppingRule } from './stoppingRule.ts'

/** One evaluation of the forces: where, and what they were per mass [m/s²]. */
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
  /**
   * What ended it, if not the step's end: a stop, a joint, a take-off, that the law changes too much for a longer step, or
   * that a trial could not be trusted and was halved.
   */
  ends?: 'stop' | 'joint' | 'take-off' | 'cut' | 'halved'
}

/** An evaluation for a block that does not slide, whether static friction holds it; `a` is the drive to hold against. */
export interface Standing extends Evaluation {
  /** When, in the step that the policy asked for [s]. */
  begins: number
}

/** One try of a policy that tries steps: how far off it is and how far off it may be [m], and what became of it. */
export interface Attempt {
  error: number
  allowed: number
  accepted: boolean
}

/** A step that the timestep policy asked for. */
export interface PolicyStep {
  /** The policy took it back: it was a try, or half of one that was refused. */
  takenBack: boolean
  /** The try that it was part of: a whole step, two halves, and before them a step that an event cut short. */
  attempt?: Attempt
  dt: number
  from: State
  to: State
  stretches: Stretch[]
  /** Where no stretch begins with it, static friction held: the block is at rest, or rode on the belt. */
  standings: Standing[]
  outcome: Motion['outcome']
}

/**
 * The steps inside one frame of an experiment, as they ran: the run is repeated up to the frame and observed
 * there, through the same code and to the same bits as `simulate`.
 *
 * @param frame the row of the trajectory that the frame ends at, 1 or more
 * @throws ExperimentError for an experiment that can't be run, RangeError for a frame that it does not have
 */
export function traceFrame(experiment: Experiment, frame: number): PolicyStep[] {
  const steps: PolicyStep[] = []
  let reached = 0
  const loop = new FrameLoop(parseExperiment(experiment), (motion, integrator, rule) => {
    if (reached < frame) advance(motion, integrator, rule)
    else steps.push(traceStep(motion, integrator, rule))
  })
  const { run } = loop
  let judged = 0
  let saved = 0
  run.watcher = {
    restored: () => {
      for (const step of steps.slice(saved)) step.takenBack = true
      saved = steps.length
    },
    judged: (accepted) => {
      const attempt = { error: run.error, allowed: run.allowed, accepted }
      for (const step of steps.slice(judged)) step.attempt = attempt
      judged = saved = steps.length
    },
  }
  do reached++
  while (loop.next() && reached < frame)
  if (reached !== frame || run.frames !== frame)
    throw new RangeError(
      `The run has no frame ${String(frame)}; its frames are 1 to ${run.frames}.`,
    )
  return steps
}

/** Takes a step as `advance` does, and notes what happens in it. */
function traceStep(motion: Motion, integrator: Integrator, rule: StoppingRule): PolicyStep {
  const { dt } = motion
  const from = stateOf(motion)
  const stretches: Stretch[] = []
  const standings: Standing[] = []
  let evaluations: Evaluation[] | undefined
  const { stiffness, drag } = motion.law
  motion.observe(({ atS: s, atV: v, atA: a, tangential, weight, curvature }) => {
    const drive = tangential - stiffness * s - drag * v * Math.abs(v)
    const press = weight + curvature * (v * v)
    const evaluation = { s, v, drive, press, a }
    if (evaluations) evaluations.push(evaluation)
    // Outside a step of the integrator only static friction asks.
    else standings.push({ ...evaluation, begins: motion.elapsed })
  })
  const watchedIntegrator: Integrator = {
    ...integrator,
    step: () => {
      const before = {
        ...{ dt: motion.dt, from: stateOf(motion), slip: motion.slipHeld ? motion.slip : 0 },
        reused: motion.known ? motion.a : undefined,
      } as const
      evaluations = []
      integrator.step(motion)
      const tried = { ...before, to: stateOf(motion), evaluations }
      evaluations = undefined
      stretches[stretches.length - 1]!.tries.push(tried)
    },
  }
  const watchedRule: StoppingRule = {
    ...rule,
    step: () => {
      const stretch: Stretch = { begins: motion.elapsed, tries: [] }
      stretches.push(stretch)
      const asked = motion.dt
      rule.step(motion, watchedIntegrator)
      if (motion.v === motion.law.belt) stretch.ends = 'stop'
      else if (motion.outcome === 'left-the-track') stretch.ends = 'take-off'
      else if (motion.s === motion.to || motion.s === motion.from) stretch.ends = 'joint'
      else if (motion.dt < stretch.tries[0]!.dt) stretch.ends = 'halved'
      else if (motion.dt < asked) stretch.ends = 'cut'
    },
  }
  advance(motion, watchedIntegrator, watchedRule)
  motion.observe(undefined)
  return {
    ...{ takenBack: false, dt, from, to: stateOf(motion) },
    ...{ stretches, standings, outcome: motion.outcome },
  }
}

function stateOf({ s, v }: Motion): State {
  return { s, v }
}
