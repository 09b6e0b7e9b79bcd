import { describe, expect, it } from 'vitest'
import { energyResidual } from '../../src/measure/energy.ts'
import { exact, integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment, IntegratorId } from '../../src/physics/index.ts'
import { last } from './truth.ts'

/** The largest energy residual over the frames [J], with steps of that length. */
function residual(experiment: Experiment, integrator: IntegratorId, step: number): number {
  const run = simulate({ ...experiment, integrator, timestep: { kind: 'substeps', step } })
  return energyResidual(run).reduce((most, each) => Math.max(most, Math.abs(each)), 0)
}

/**
 * The order at which something falls as the step is halved: the steepest line through the errors that are above rounding,
 * from the first of them to the last.
 */
function orderOf(errors: readonly number[], rounding: number): number {
  const above = errors.filter((error) => error > rounding)
  expect(above.length).toBeGreaterThanOrEqual(3)
  return Math.log2(above[0]! / above.at(-1)!) / (above.length - 1)
}

// 50 J at the most, in tens of steps: some ulps of that are 1e-13. What is above ten times that shows an order.
const ROUNDING = 1e-12

/** From a step at which the method's error is its leading term, halved down to rounding. */
const coarsest: Record<string, number> = { rk8: 1 / 5, rk4: 1 / 20, yoshida4: 1 / 20 }

// One pass each, from a speed to a lower one: no turn, so that errors of one sign add up to one line.
const rubbed: { name: string; experiment: Experiment }[] = [
  {
    name: 'in a half-pipe',
    experiment: {
      scene: 'half-pipe',
      parameters: { muStatic: 0.2, muKinetic: 0.2, position: -2, speed: 2 },
      frames: { kind: 'steady', fps: 5 },
      duration: 1,
    },
  },
  {
    name: 'on a run-out with a bend',
    experiment: {
      scene: 'run-out',
      parameters: { length: 1, bendRadius: 3, angle: 40, muStatic: 0.3, muKinetic: 0.3, speed: 2 },
      frames: { kind: 'steady', fps: 5 },
      duration: 1.6,
    },
  },
]

describe.each(rubbed)('with friction $name', ({ experiment }) => {
  it.each(integrators)('the energy residual of $id falls with the order of $id', (method) => {
    const first = coarsest[method.id] ?? 1 / 40
    const steps = [1, 2, 4, 8, 16].map((parts) => first / parts)
    const errors = steps.map((step) => residual(experiment, method.id, step))
    // A joint cuts the steps on both its sides, so that the line is not quite straight. Friction in a bend depends on v.
    const least = method.orderWithSpeed - 0.4
    expect(orderOf(errors, ROUNDING), errors.join(', ')).toBeGreaterThan(least)
  })

  it('the heat of rk8 at 60 fps is what is missing from the energy, to rounding', () => {
    const run = simulate({
      ...experiment,
      integrator: 'rk8',
      frames: { kind: 'steady', fps: 60 },
    })
    expect(last(run.heat)).toBeGreaterThan(5)
    const most = energyResidual(run).reduce((most, each) => Math.max(most, Math.abs(each)), 0)
    expect(most).toBeLessThanOrEqual(ROUNDING)
  })
})

it('through stops, turns and joints the energy residual of rk8 still falls to rounding', () => {
  for (const experiment of [
    { scene: 'half-pipe', parameters: { muStatic: 0.05, muKinetic: 0.05 }, duration: 8 },
    { scene: 'run-out', parameters: { position: 1, speed: -3 }, duration: 6 },
  ] as const) {
    // Near rest an event's own rounding comes to a few more ulps.
    expect(residual(experiment, 'rk8', 1 / 100)).toBeLessThanOrEqual(10 * ROUNDING)
    expect(residual(experiment, 'rk8', 1 / 10)).toBeLessThanOrEqual(1e-5)
  }
})

// 5 m/s upwards at first, so that the air's loss is counted through the turn too, and then near the speed at which drag
// and weight are equal, 4.4 m/s: 92 J of weight and 3 of its speed heat the air.
const drag: Experiment = {
  scene: 'fall',
  parameters: { drag: 0.5, speed: -5 },
  frames: { kind: 'steady', fps: 5 },
  duration: 3,
}

describe('with drag', () => {
  it('heat is what the air takes', () => {
    const run = simulate({ ...drag, integrator: 'rk8', frames: { kind: 'steady', fps: 240 } })
    const { s, v } = exact(drag, drag.duration!)
    const lost = 9.81 * s + 0.5 * 25 - 0.5 * v * v
    expect(lost).toBeGreaterThan(50)
    expect(Math.abs(last(run.heat) - lost)).toBeLessThanOrEqual(1e-10)
  })

  it.each(integrators)('the energy residual of $id falls with the order of $id', (method) => {
    // At 1/5 s a step of rk8 is as long as the air's own time, m/(c v): not yet where its leading term is all.
    const first = method.id === 'rk8' ? 1 / 10 : (coarsest[method.id] ?? 1 / 40)
    const steps = [1, 2, 4, 8, 16].map((parts) => first / parts)
    const errors = steps.map((step) => residual(drag, method.id, step))
    expect(orderOf(errors, ROUNDING), errors.join(', ')).toBeGreaterThan(
      method.orderWithSpeed - 0.4,
    )
  })
})

it('no heat is made without friction and without air', () => {
  for (const scene of ['fall', 'half-pipe'] as const)
    expect(simulate({ scene, integrator: 'rk4' }).heat.every((heat) => heat === 0)).toBe(true)
})
