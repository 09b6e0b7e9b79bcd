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
