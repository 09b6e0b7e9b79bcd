import type { Experiment } from './experiment.ts'
import { FrameLoop } from './frameLoop.ts'
import type { Integrator } from './integrator.ts'
import type { Motion } from './motion.ts'
import { parseExperiment } from './parse.ts'
import type { State } from './state.ts'
import { advance } from './step.ts'
import type { StoppingRule } from './stoppingRule.ts'

/** One evaluation of the forces: the state, and the forces per mass [m/s²]. */
export interface Evaluation extends State {
  drive: number
  press: number
  /** dv/dt there: drive − slip μk press. */
  a: number
}

/** One step of the integrator as it was tried, accepted or not. */
export interface TriedStep {
  /** Its length [s]. */
  dt: number
  from: State
  to: State
  /** The slip direction that was held; 0 if friction followed the sign of each v. */
  slip: -1 | 0 | 1
  /** The acceleration at `from`, if it was reused from the step before [m/s²]. */
  reused: number | undefined
  /** Without a reused one. */
  evaluations: Evaluation[]
}

/** A part of a step without a jump of the law: the tries to find its end, of which the last was accepted. */
export interface Stretch {
  /** When it begins, in the step that the policy asked for [s]. */
  begins: number
  tries: TriedStep[]
  /**
   * What ended it, if not the step's end: a stop, a joint, a take-off, a cut because the law changes too much, or
   * the halving of an implausible trial.
   */
  ends?: 'stop' | 'joint' | 'take-off' | 'cut' | 'halved'
}

/** An evaluation that decides whether static friction holds a block that does not slide; `a` is the drive. */
export interface Standing extends Evaluation {
  /** When this happens, in the step that the policy asked for [s]. */
  begins: number
}

/** One try of a policy that tries steps: its error and its tolerance [m], and whether it was accepted. */
export interface Attempt {
  error: number
  allowed: number
  accepted: boolean
}

/** A step that the timestep policy asked for. */
export interface PolicyStep {
  /** The policy took it back: it was a whole try, or half of a rejected one. */
  takenBack: boolean
  /** The try that it belongs to: a whole step, its two halves, and once more the whole where an event ended that one. */
  attempt?: Attempt
  /** The length that was asked for, and its own [s]: less where the policy takes a step up to its first event only. */
  asked: number
  dt: number
  from: State
  to: State
  stretches: Stretch[]
  /** If no stretch begins with one, static friction held: the block is at rest or rides on the belt. */
  standings: Standing[]
  outcome: Motion['outcome']
}

/**
 * The steps inside one frame of an experiment. The run is simulated again up to the frame and observed
 * there, with the same code and the same bits as `simulate`.
 *
 * @param frame the row of the trajectory that the frame ends at, 1 or more
 * @throws ExperimentError for an experiment that can't be run, RangeError for a frame that it does not have
 */
export function traceFrame(experiment: Experiment, frame: number): PolicyStep[] {
  const steps: PolicyStep[] = []
  let reached = 0
  const loop = new FrameLoop(parseExperiment(experiment), (motion, integrator, rule, once) => {
    if (reached < frame) advance(motion, integrator, rule, once)
    else steps.push(traceStep(motion, integrator, rule, once))
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

/** Takes a step like `advance`, and records what happens in it. */
function traceStep(
  motion: Motion,
  integrator: Integrator,
  rule: StoppingRule,
  once: boolean | undefined,
): PolicyStep {
  const asked = motion.dt
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
    // Outside a step of the integrator, only static friction evaluates the forces.
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
  advance(motion, watchedIntegrator, watchedRule, once)
  motion.observe(undefined)
  return {
    ...{ takenBack: false, asked, dt: motion.dt, from, to: stateOf(motion) },
    ...{ stretches, standings, outcome: motion.outcome },
  }
}

function stateOf({ s, v }: Motion): State {
  return { s, v }
}
