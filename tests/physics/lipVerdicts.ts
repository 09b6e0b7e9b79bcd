import { simulate } from '../../src/physics/index.ts'
import type { Experiment, IntegratorId, Trajectory } from '../../src/physics/index.ts'
import { lipTime } from './fine.ts'
import type { LipCase } from './generated.ts'
import { last } from './truth.ts'

/**
 * What a method can know about a lip. A step of z = ω dt changes the energy, in units of m g R, by at most C z^(p + 1), and
 * adds at most D z^(p + 1) to the distance from the true state, in units of R and ω R: both were measured as the largest over
 * amplitudes up to 83°, phases and z from 0.05 to 3.1, and rounded up. Where the excess is within twice the sum of the
 * first over the run's frames, the method's own block may rightly leave or stay when the true one does not. Beyond it, a
 * method whose events are found has no excuse. (Verlet's energy does not add up, but over a few swings a bound that does
 * is within a small factor of one that does not.)
 */
const stepErrors: Record<string, { order: number; C: number; D: number }> = {
  'velocity-verlet': { order: 2, C: 0.23, D: 0.25 },
  midpoint: { order: 2, C: 0.2, D: 0.33 },
  rk4: { order: 4, C: 0.017, D: 0.017 },
  rk8: { order: 8, C: 1.1e-4, D: 1.6e-4 },
  yoshida4: { order: 4, C: 0.066, D: 0.1 },
  'implicit-midpoint': { order: 2, C: 0.04, D: 0.12 },
}

/** Of either, per frame: a few roundings of numbers near 1. */
const ROUNDING = 8 * Number.EPSILON

function omega({ parameters }: Experiment): number {
  const { gravity, radius } = parameters as { gravity: number; radius: number }
  return Math.sqrt(gravity / radius)
}

/** The bounds of a run's errors, from its frames up to that time. */
function errors(run: Trajectory, experiment: Experiment, until: number) {
  const { order, C, D } = stepErrors[experiment.integrator!]!
  let energy = 0
  let state = 0
  for (let row = 1; row <= run.frames && run.time[row - 1]! <= until; row++) {
    const z = omega(experiment) * (run.time[row]! - run.time[row - 1]!)
    energy += C * z ** (order + 1) + ROUNDING
    state += D * z ** (order + 1) + ROUNDING
  }
  return { energy, state }
}

interface Verdict {
  decided: boolean
  problem: string | undefined
}

/** Compares one run with the truth. */
function judge({ experiment, excess, time }: TimedLip, integrator: IntegratorId): Verdict {
  const asked = { ...experiment, integrator }
  const run = simulate(asked)
  const { energy, state } = errors(run, asked, time)
  if (Math.abs(excess) <= 2 * energy) return { decided: false, problem: undefined }
  const { kind } = run.outcome
  const verdict = (problem: string) => ({
    decided: true,
    problem: `${problem}: excess ${excess}, ${JSON.stringify(asked)}`,
  })
  if (excess < 0)
    return kind === 'moving'
      ? { decided: true, problem: undefined }
      : verdict(`${kind} at ${run.outcome.time} s, but it never leaves`)
  if (kind !== 'left-the-track') return verdict(`${kind}, but it leaves at ${time} s`)
  const { radius, speed } = experiment.parameters as { radius: number; speed: number }
  const place = Math.sign(speed) * (Math.PI / 2) * radius
  // To rounding: π/2 R itself is rounded.
  if (!(Math.abs(last(run.s) - place) <= Number.EPSILON * radius * 2))
    return verdict(`left at ${last(run.s)} m, not at its lip at ${place} m`)
  // At the lip it moves at √(2 excess) ω R: so much time is an error of the state. An error of energy, which is half the
  // excess at the most, changes that speed by less than a half.
  const late = Math.abs(run.outcome.time - time) * omega(experiment)
  const bound = (2 * state) / Math.sqrt(2 * excess) + 1e-12
  return late <= bound
    ? { decided: true, problem: undefined }
    : verdict(`left at ${run.outcome.time} s, not at ${time} s: ${late / bound} times the bound`)
}

/** A case, and when the true block leaves [s]; Infinity where it does not. */
export interface TimedLip extends LipCase {
  time: number
}

export function timed(cases: readonly LipCase[]): TimedLip[] {
  return cases.map((each) => ({
    ...each,
    time: each.excess > 0 ? lipTime(each.experiment, each.excess) : Infinity,
  }))
}

/** Compares the runs of one method with the truth: in how many it can know, and what is wrong in those. */
export function judgeLips(cases: readonly TimedLip[], integrator: IntegratorId) {
  const verdicts = cases.map((each) => judge(each, integrator))
  return {
    decided: verdicts.filter(({ decided }) => decided).length,
    problems: verdicts.flatMap(({ problem }) => problem ?? []),
  }
}
