import { describe, expect, it } from 'vitest'
import { exact, integrators, simulate, stoppings } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { Chance } from './generated.ts'
import { last } from './truth.ts'

/** The rules that know of static friction. */
const rests = stoppings.filter(({ holdsSlip }) => holdsSlip).map(({ id }) => id)
const methods = integrators.map(({ id }) => id)

/** A block stays for ever: by its run, to the bit, and by the reference. */
function expectToStay(experiment: Experiment): void {
  const { position = 0 } = experiment.parameters!
  const run = simulate(experiment)
  const where = JSON.stringify(experiment)
  expect(run.outcome, where).toEqual({ kind: 'at-rest', time: 0 })
  expect(
    run.s.every((s) => s === position),
    where,
  ).toBe(true)
  expect(
    run.v.every((v) => v === 0),
    where,
  ).toBe(true)
  expect(exact(experiment, 1e6), where).toEqual({ s: position, v: 0 })
}

describe.each(rests)('where drive and static friction are equal, with stops %s,', (stopping) => {
  it.each(methods)(
    'a block at rest on 45° with μs = μk = 1 stays for an hour: %s',
    (integrator) => {
      const chance = new Chance(45)
      for (const scene of ['ramp', 'run-out', 'spring'] as const)
        for (let i = 0; i < samples(5); i++)
          expectToStay({
            scene,
            parameters: {
              ...{ angle: 45, muStatic: 1, muKinetic: 1 },
              ...{ gravity: chance.scale(1e-3, 1e3), mass: chance.scale(1e-3, 1e3) },
              ...(scene === 'spring'
                ? { stiffness: 0 }
                : {
                    position: scene === 'ramp' ? chance.between(-1e3, 1e3) : chance.between(-9, 4),
                  }),
            },
            ...{ stopping, integrator, frames: { kind: 'steady', fps: 5 }, duration: 3600 },
          })
    },
  )

  it.each(methods)('a block at rest on the flat stays, without any friction: %s', (integrator) => {
    for (const muStatic of [0, 0.3])
      expectToStay({
        scene: 'ramp',
        parameters: { angle: 0, muStatic, muKinetic: muStatic, position: 1.1 },
        ...{ stopping, integrator, duration: 60 },
      })
  })

  it('a block that stops on 45° with μs = μk = 1 stays where it stopped', () => {
    for (const integrator of methods) {
      const run = simulate({
        scene: 'ramp',
        parameters: { angle: 45, muStatic: 1, muKinetic: 1, speed: -5 },
        ...{ stopping, integrator, duration: 600 },
      })
      expect(run.outcome.kind, integrator).toBe('at-rest')
      const row = run.v.indexOf(0)
      expect(
        run.s.subarray(row).every((s) => s === last(run.s)),
        integrator,
      ).toBe(true)
    }
  })
})

/** Springs on the flat put down where |k x| = μs N (1 + excess), with signs in turn. */
function springs(count: number, excess: number): { experiment: Experiment; position: number }[] {
  const chance = new Chance(1785)
  return Array.from({ length: count }, (_, i) => {
    const mass = chance.scale(1e-3, 1e3)
    const stiffness = chance.scale(1, 1e5) * mass
    const muStatic = chance.scale(1e-3, 10)
    const muKinetic = i % 3 === 0 ? muStatic : chance.between(0.1, 0.999) * muStatic
    const size = ((muStatic * mass * 9.81) / stiffness) * (1 + excess)
    const position = i % 2 === 0 ? size : -size
    return {
      experiment: {
        scene: 'spring',
        parameters: { angle: 0, stiffness, mass, muStatic, muKinetic, position },
        // A fifth of a radian of the fastest: no method is near its limit.
        timestep: { kind: 'substeps', step: 0.2 / Math.sqrt(stiffness / mass) },
        duration: 20 / Math.sqrt(stiffness / mass),
      },
      position,
    }
  })
}

describe('a spring on the flat, put down at rest', () => {
  it('stays where k x = μs N, and a little nearer', () => {
    for (const excess of [0, -1e-12])
      for (const { experiment } of springs(samples(500), excess))
        for (const stopping of rests) expectToStay({ ...experiment, stopping })
  })

  it('goes where k x is beyond μs N by 1e-12', () => {
    for (const { experiment, position } of springs(samples(500), 1e-12)) {
      const where = JSON.stringify(experiment)
      const run = simulate({ ...experiment, integrator: 'rk8' })
      // It swings by twice the excess over kinetic friction: by 2e-12 of its way at the least, 9000 ulps.
      expect((position - last(run.s)) / position, where).toBeGreaterThan(1e-12)
      const end = exact(experiment, experiment.duration!)
      expect((position - end.s) / position, where).toBeGreaterThan(1e-12)
    }
  })
})

it('a spring that stops where k x = μs N stays there', () => {
  const cases = springs(samples(200), 0)
  let atOnce = 0
  for (const { experiment, position } of cases) {
    // From rest at 3 μ N/k it swings about μ N/k to −μ N/k, on the other side, in half a period.
    const parameters = {
      ...experiment.parameters,
      muKinetic: experiment.parameters!.muStatic!,
      position: 3 * position,
    }
    const { stiffness, mass } = experiment.parameters!
    const omega = Math.sqrt(stiffness! / mass!)
    const swing = {
      ...experiment,
      parameters,
      integrator: 'rk8',
      timestep: { kind: 'substeps', step: 0.05 / omega },
    } as const
    const run = simulate(swing)
    const where = JSON.stringify(swing)
    expect(run.outcome.kind, where).toBe('at-rest')
    // Order 8 at ω dt = 0.05 leaves nothing but rounding: an ulp in each of sixty steps.
    expect(Math.abs(last(run.s) / -position - 1), where).toBeLessThanOrEqual(1e-13)
    const end = exact(swing, 1e3 / omega)
    expect(Math.abs(end.s / -position - 1), where).toBeLessThanOrEqual(1e-14)
    expect(end.v, where).toBe(0)
    atOnce += Number(run.outcome.time * omega < 1.5 * Math.PI)
  }
  // Those roundings make some stop beyond the tie, by more than a comparison's own rounding: they rightly swing once more,
  // over that excess. Without a tie half of them would.
  expect(atOnce).toBeGreaterThan(0.9 * cases.length)
})

it('a slope of 45° with μs a little below 1 lets a block go, as slowly as the difference says', () => {
  const experiment: Experiment = {
    scene: 'ramp',
    parameters: { angle: 45, muStatic: 1 - 1e-12, muKinetic: 1 - 1e-12 },
    duration: 3600,
  }
  // ½ g sin 45° (1 − μ) t²; of the difference, 1e-12, two roundings of an ulp are 4e-4.
  const distance = 0.5 * 9.81 * Math.SQRT1_2 * (1 - (1 - 1e-12)) * 3600 ** 2
  for (const s of [last(simulate(experiment).s), exact(experiment, 3600).s])
    expect(Math.abs(s / distance - 1)).toBeLessThanOrEqual(1e-3)
})
