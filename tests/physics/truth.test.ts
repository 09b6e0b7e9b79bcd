import { describe, expect, it } from 'vitest'
import { exactMotion, integrators, simulate } from '../../src/physics/index.ts'
import type { FramesChoice, Timestep } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { last, relative, truth } from './truth.ts'

const timesteps: Timestep[] = [
  { kind: 'variable' },
  { kind: 'substeps', step: 1 / 240 },
  { kind: 'fixed', step: 1 / 60 },
  { kind: 'fixed', step: 1 / 1000 },
]
const frames: FramesChoice[] = [
  { kind: 'steady', fps: 5 },
  { kind: 'steady', fps: 30 },
  { kind: 'steady', fps: 144 },
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 7 },
  { kind: 'hitch', fps: 60, every: 0.6, length: 0.5 },
]
const secondOrder = integrators.filter(({ order }) => order >= 2)

describe('on the ramp every method of second order or more is exact with located stops', () => {
  const ramps = truth.filter(({ experiment }) => experiment.scene === 'ramp')
  describe.each(secondOrder.map(({ id }) => id))('%s', (integrator) => {
    // The acceleration is constant between stops, so nothing but rounding is left: a few thousand steps, each off by
    // an ulp of s or less, add up to well below 1e-12.
    it.each(ramps)('$name', ({ experiment, outcome, s }) => {
      const truth = exactMotion(experiment)
      for (const timestep of timesteps)
        for (const clock of frames.slice(0, samples(frames.length))) {
          const run = simulate({ ...experiment, integrator, timestep, frames: clock })
          const where = JSON.stringify({ timestep, clock })
          let worst = 0
          for (let row = 0; row <= run.frames; row++) {
            const at = truth(run.stateTime[row]!, { s: 0, v: 0 })
            worst = Math.max(worst, relative(run.s[row]! - at.s, at.s))
          }
          expect(worst, where).toBeLessThanOrEqual(1e-12)
          // Under `fixed` the state's time may still be before the stop.
          if (outcome === 'at-rest' && last(run.v) === 0) {
            expect(run.outcome.kind, where).toBe('at-rest')
            expect(relative(last(run.s) - s, s), where).toBeLessThanOrEqual(1e-12)
          }
          if (outcome === 'at-rest' && timestep.kind !== 'fixed') {
            expect(run.outcome.kind, where).toBe('at-rest')
            expect(last(run.v), where).toBe(0)
          }
        }
    })
  })

  it.each(ramps.filter(({ outcome }) => outcome === 'at-rest'))(
    'finds the instant of the stop: $name',
    (each) => {
      const { outcome } = simulate({ ...each.experiment, frames: { kind: 'steady', fps: 5 } })
      expect(outcome.kind).toBe('at-rest')
      // One rounding of v/a and one of the sum with the frame's start, each of a time below 2 s.
      expect(Math.abs(outcome.time - each.stops.at(-1)!)).toBeLessThanOrEqual(4 * Number.EPSILON)
    },
  )
})

describe('rk4 with located stops', () => {
  // Bounds from a prototype of a hundred lines, which did better than each of them.
  const at60: Record<string, number> = {
    'half-pipe': 4e-6,
    'run-out': 6e-7,
    fall: 2e-6,
    ramp: 1e-12,
  }
  const fine: Record<string, number> = { spring: 3e-7 }

  it.each(truth.filter(({ experiment }) => experiment.scene in at60))(
    'at 60 fps: $name',
    (each) => {
      const run = simulate({ ...each.experiment, integrator: 'rk4' })
      expect(relative(last(run.s) - each.s, each.s)).toBeLessThanOrEqual(
        at60[each.experiment.scene]!,
      )
      expect(run.outcome.kind).toBe(each.outcome)
      if (each.outcome === 'at-rest') expect(last(run.v)).toBe(0)
    },
  )

  it.each(truth)('with steps of 1/4000 s: $name', (each) => {
    const run = simulate({
      ...each.experiment,
      integrator: 'rk4',
      timestep: { kind: 'substeps', step: 1 / 4000 },
    })
    const bound = fine[each.experiment.scene] ?? 1e-11
    expect(relative(last(run.s) - each.s, each.s)).toBeLessThanOrEqual(bound)
    expect(run.outcome.kind).toBe(each.outcome)
  })
})
