import { expect, it } from 'vitest'
import { energyResidual } from '../../src/measure/energy.ts'
import { exact, integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { last } from './truth.ts'

const HOUR = 3600
const located = { integrator: 'velocity-verlet', stopping: 'located' } as const

/**
 * Each frame rounds s and v once or twice, by half an ulp: u = 2⁻⁵³. The increment of v is the same in every frame, so that
 * within a binade its rounding may be too; the worst is u times the frames, and half of the frames fall into the binade of
 * the last speed.
 */
const bound = (frames: number) => (Number.EPSILON / 2) * frames

it.each([5, 60, 144])(
  'an hour of sliding at %i fps is off by no more than its frames’ rounding, relative to the path',
  (fps) => {
    for (const parameters of [{}, { speed: -200 }, { angle: 11.5, muStatic: 0.2 }]) {
      const experiment: Experiment = {
        scene: 'ramp',
        ...{ parameters, ...located, duration: HOUR, frames: { kind: 'steady', fps } },
      }
      const run = simulate(experiment)
      const { s } = exact(experiment, HOUR)
      expect(run.outcome.kind).toBe('moving')
      expect(Math.abs(s)).toBeGreaterThan(1e4)
      expect(Math.abs(last(run.s) / s - 1)).toBeLessThanOrEqual(bound(run.frames))
    }
  },
)

it('a block that has stopped does not creep within an hour, by a single bit', () => {
  for (const { id, order } of integrators) {
    if (order < 2) continue
    for (const parameters of [
      { angle: 10, speed: 5 },
      { angle: 25, muStatic: 0.5, speed: -4 },
    ]) {
      const experiment: Experiment = {
        scene: 'ramp',
        ...{ parameters, integrator: id, stopping: 'located', duration: HOUR },
        frames: { kind: 'steady', fps: 60 },
      }
      const run = simulate(experiment)
      const end = exact(experiment, HOUR)
      expect(run.outcome.kind).toBe('at-rest')
      expect(last(run.v)).toBe(0)
      const rest = run.v.indexOf(0)
      expect(Math.abs(last(run.s) / end.s - 1)).toBeLessThanOrEqual(bound(rest))
      expect(run.s.subarray(rest).every((s) => s === last(run.s))).toBe(true)
    }
  }
})

it('the energy error of Verlet at a fixed step stays bounded over 10 000 s in the half-pipe', () => {
  const run = simulate({
    scene: 'half-pipe',
    ...{ ...located, duration: 10_000 },
    timestep: { kind: 'fixed', step: 1 / 30 },
    frames: { kind: 'steady', fps: 30 },
  })
  expect(run.outcome.kind).toBe('moving')
  const errors = energyResidual(run)
  const tenth = Math.floor(errors.length / 10)
  const [first, final] = [errors.subarray(0, tenth), errors.subarray(-tenth)].map((part) => ({
    largest: part.reduce((most, each) => Math.max(most, Math.abs(each)), 0),
    mean: part.reduce((sum, each) => sum + each, 0) / tenth,
  }))
  // It swings with the block, as (ω dt)² does: the error must be there. Each tenth holds 350 swings, at 80 frames each, so
  // that both see the largest to a few parts in a million, and the mean of it to one part in as many frames.
  expect(first!.largest).toBeGreaterThan(1e-4)
  expect(Math.abs(final!.largest / first!.largest - 1)).toBeLessThanOrEqual(1e-4)
  expect(Math.abs(final!.mean - first!.mean)).toBeLessThanOrEqual(1e-3 * first!.largest)
})
