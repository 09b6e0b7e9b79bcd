import { expect, it } from 'vitest'
import { simulate } from '../../src/physics/index.ts'
import type { FramesChoice, Timestep } from '../../src/physics/index.ts'
import { policyOf } from '../../src/physics/timesteps/index.ts'

const choices: Timestep[] = [
  { kind: 'per-frame', step: 1 / 60 },
  { kind: 'variable' },
  { kind: 'capped', cap: 0.01 },
  { kind: 'substeps', step: 1 / 250 },
  { kind: 'substeps', step: 1 },
  { kind: 'fixed', step: 1 / 250 },
  { kind: 'substeps', step: 1 / 250, maxSteps: 2 },
  { kind: 'fixed', step: 1 / 250, maxSteps: 2 },
  { kind: 'fixed', step: 1 / 250, cap: 0.01 },
]

it.each(choices)('a policy tells how many steps a run takes, at the most: %o', (timestep) => {
  for (const frames of [
    { kind: 'steady', fps: 60 },
    { kind: 'hitch', fps: 60, every: 0.5, length: 0.3 },
  ] satisfies FramesChoice[]) {
    const { experiment, steps, frames: count } = simulate({ scene: 'fall', timestep, frames })
    const told = policyOf(experiment.timestep).steps(experiment.duration, count)
    expect(steps).toBeLessThanOrEqual(told)
    // Each frame may round up to a step more, and dropped steps are told as well.
    expect(told).toBeLessThanOrEqual(steps + count)
  }
})
