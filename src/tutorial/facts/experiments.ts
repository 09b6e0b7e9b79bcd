import { frameRateSpread, spreadOf, withoutRounding } from '../../measure/index.ts'
import type { Spread } from '../../measure/index.ts'
import { simulate } from '../../physics/index.ts'
import type { Experiment } from '../../physics/index.ts'

/** The kick that the page opens with: up 15° at 5 m/s, with μ = 0.5. */
export const kick: Experiment = {
  scene: 'ramp',
  parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  duration: 1,
}

/** The two ways of going about it that the text holds against each other. */
export const paperStep = { integrator: 'semi-implicit-euler', stopping: 'clamped' } as const
export const takeHome = { integrator: 'velocity-verlet', stopping: 'located' } as const

/** Where a run ends [m]. */
export function end(experiment: Experiment): number {
  return simulate(experiment).drawnS.at(-1)!
}

export function at(fps: number, experiment: Experiment): Experiment {
  return { ...experiment, frames: { kind: 'steady', fps } }
}

/** How far apart runs of an experiment end, at those frame rates or at all that the spread is measured at [m]. */
export function apart(experiment: Experiment, rates?: readonly number[]): number {
  const spread: Spread = rates
    ? spreadOf(rates.map((fps) => simulate(at(fps, experiment))))
    : frameRateSpread(experiment)
  if (!spread.agree) throw new Error('The text tells of a distance, and the outcomes differ.')
  return withoutRounding(spread.distance, spread.scale)
}
