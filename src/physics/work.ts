import { limits } from './experiment.ts'
import type { ResolvedExperiment } from './experiment.ts'
import { clockOf } from './frames/index.ts'
import type { Integrator } from './integrator.ts'
import { integrators } from './integrators/index.ts'
import { entry } from './lists.ts'
import { measuring } from './measured.ts'
import type { Problem } from './problems.ts'
import type { Parameters } from './state.ts'
import { policyOf } from './timesteps/index.ts'
import { sinCosDegrees } from './trigonometry.ts'

/** Trial steps to locate one event: regula falsi on a smooth residual needs 5 to 10. */
const TRIALS = 8

/**
 * The reasons why a run would take too long: too many frames, too many steps or, if the experiment is otherwise valid,
 * too many evaluations of the acceleration.
 */
export function workProblems(experiment: ResolvedExperiment, whole: boolean): Problem[] {
  const { duration, timeScale, frames, timestep, integrator, stopping, parameters } = experiment
  const problems: Problem[] = []
  const frameCount = clockOf(frames).frames(duration)
  if (frameCount > limits.frames)
    problems.push({
      path: 'duration',
      message: `${duration} s asks for ${count(frameCount)} frames, more than ${count(limits.frames)}; shorten it or lower the frame rate`,
    })
  // A frame that is snapped to a display may count one refresh more than it lasts.
  const added =
    frames.delta === 'snapped' ? frameCount / (frames.snapTo ?? measuring.snapTo.initial) : 0
  const gameTime = timeScale * (duration + added)
  const steps = policyOf(timestep).steps(gameTime, frameCount)
  if (steps > limits.steps)
    problems.push({
      path: 'timestep.step',
      message: `asks for ${count(steps)} steps, more than ${count(limits.steps)}; lengthen the step or shorten the duration`,
    })
  if (!whole || problems.length > 0) return problems
  const { least, most }: Integrator['evaluations'] = entry(integrators, integrator).evaluations
  const located = stopping === 'located' ? reversals(parameters, gameTime) : 0
  // A typical step lies between the fewest and the most evaluations: for implicit midpoint 6 of 1 to 40.
  const evaluations = (steps + TRIALS * located) * Math.sqrt(least * most)
  if (evaluations > limits.evaluations)
    problems.push({
      path: 'duration',
      message: `${duration} s asks for about ${about(evaluations)} evaluations of the acceleration, more than ${count(limits.evaluations)}, to locate up to ${about(located)} reversals; shorten it, slow the oscillation or choose another stopping rule`,
    })
  return problems
}

/**
 * An upper bound on the reversals of a block that oscillates, for a rule that locates them: half-swings last π/ω or
 * longer, and friction ends them. Elsewhere a block reverses once or twice, which costs nothing.
 */
function reversals(parameters: Parameters, duration: number): number {
  const { gravity = 0, mass = 1, angle = 0, radius, stiffness = 0 } = parameters
  const { position = 0, speed = 0, beltSpeed = 0, muStatic = 0, muKinetic = 0 } = parameters
  // The energy that friction takes in a half-swing of a pipe, from θ₁ ≤ ½π to −θ₂, gives tan ½(θ₁ − θ₂) ≥ μk, and
  // atan μk ≥ μk/(1 + μk).
  if (radius !== undefined)
    return Math.min(
      (Math.sqrt(gravity / radius) * duration) / Math.PI,
      ((Math.PI / 4) * (1 + muKinetic)) / muKinetic + 1,
    )
  if (muStatic === 0) return 0
  const { sin, cos } = sinCosDegrees(angle)
  const omega = Math.sqrt(stiffness / mass)
  // On a belt the motion never ends, and each cycle contains two events.
  if (beltSpeed !== 0) return (omega * duration) / Math.PI
  // The drive at the end of a spring's half-swing, which friction reduces by 2 μk press each time.
  const drive = Math.abs(omega * omega * position - gravity * sin) + Math.abs(omega * speed)
  const lessened = 2 * muKinetic * gravity * cos
  return Math.min((omega * duration) / Math.PI, lessened > 0 ? drive / lessened + 1 : Infinity)
}

/** A count, rounded up: what is more than a limit reads so. */
function count(x: number): string {
  return Math.ceil(x)
    .toString()
    .replace(/\B(?=(\d{3})+$)/g, '\u202f')
}

/** Its first two digits, rounded up as well. */
function about(x: number): string {
  const unit = Number(`1e${Math.max(0, Math.ceil(x).toString().length - 2)}`)
  return count(unit * Math.ceil(x / unit))
}
