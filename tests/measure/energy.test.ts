import { describe, expect, it } from 'vitest'
import { energyResidual, mechanicalEnergy } from '../../src/measure/index.ts'
import { integrators, simulate, stoppings } from '../../src/physics/index.ts'
import type { Experiment, IntegratorId, Trajectory } from '../../src/physics/index.ts'

const pipe: Experiment = {
  scene: 'half-pipe',
  parameters: { radius: 2, position: 1.6, muKinetic: 0, muStatic: 0 },
  frames: { kind: 'steady', fps: 30 },
  duration: 1000,
}

/** Smallest and largest energy in a tenth of a run, relative to what it began with. */
function band(run: Trajectory, tenth: number): { low: number; high: number } {
  const energy = mechanicalEnergy(run)
  const part = energy.subarray((tenth * run.frames) / 10, ((tenth + 1) * run.frames) / 10)
  return { low: Math.min(...part) / energy[0]!, high: Math.max(...part) / energy[0]! }
}

const bands = (integrator: IntegratorId) => {
  const run = simulate({ ...pipe, integrator })
  expect(run.outcome.kind).toBe('moving')
  return { first: band(run, 0), last: band(run, 9), run }
}

describe('energy on the frictionless half-pipe over 1 000 s at 30 fps', () => {
  it('grows with explicit Euler until it throws the block out of the pipe', () => {
    const run = simulate({ ...pipe, integrator: 'explicit-euler' })
    expect(run.outcome.kind).toBe('left-the-track')
    expect(run.outcome.time).toBeLessThan(1000)
    const energy = mechanicalEnergy(run)
    expect(energy[run.frames]!).toBeGreaterThan(energy[0]!)
  })

  // A symplectic method keeps a nearby energy to within terms that are exponentially small in 1/Δt (Hairer, Lubich and
  // Wanner, Geometric Numerical Integration, IX), so that only the phase at which frames fall in a swing differs from
  // one tenth of the run to another: a hundredth of the band's width.
  it.each(['semi-implicit-euler', 'velocity-verlet', 'yoshida4', 'implicit-midpoint'] as const)(
    'stays within a band that does not grow with %s',
    (integrator) => {
      const { first, last } = bands(integrator)
      const width = first.high - first.low
      expect(last.high).toBeLessThanOrEqual(first.high + width / 100)
      expect(last.low).toBeGreaterThanOrEqual(first.low - width / 100)
    },
  )

  it.each([
    ['semi-implicit-euler', 1],
    ['velocity-verlet', 2],
    ['implicit-midpoint', 2],
    ['yoshida4', 4],
  ] as const)(
    'the band of %s narrows with the step to the power of its order, %i',
    (integrator, order) => {
      const width = (fps: number) => {
        const { low, high } = band(
          simulate({ ...pipe, integrator, duration: 100, frames: { kind: 'steady', fps } }),
          0,
        )
        return high - low
      }
      expect(Math.log2(width(30) / width(60))).toBeGreaterThan(order - 0.25)
      expect(Math.log2(width(30) / width(60))).toBeLessThan(order + 0.25)
    },
  )

  it('drifts down with rk4, as the fifth power of the step', () => {
    // |R(iωΔt)|² = 1 − (ωΔt)⁶/72 + …: an energy loss of (ωΔt)⁶/72 a step, of (ωΔt)⁵ a second.
    const loss = (fps: number) => {
      const run = simulate({ ...pipe, integrator: 'rk4', frames: { kind: 'steady', fps } })
      const energy = mechanicalEnergy(run)
      return 1 - Math.max(...energy.subarray(0.98 * run.frames)) / energy[0]!
    }
    expect(loss(30)).toBeGreaterThan(0)
    expect(Math.abs(Math.log2(loss(15) / loss(30)) - 5)).toBeLessThan(0.5)
  })

  it('grows with the midpoint method, slowly', () => {
    const { first, last } = bands('midpoint')
    expect(last.low).toBeGreaterThan(first.high)
  })
})

describe('friction', () => {
  const rubbed: Experiment[] = [
    { scene: 'ramp', parameters: { angle: 20, muKinetic: 0.5, muStatic: 0.5, speed: -5 } },
    { scene: 'run-out', parameters: { speed: 1 } },
    { scene: 'half-pipe', parameters: { muKinetic: 0.1, muStatic: 0.12 } },
    { scene: 'spring', parameters: { position: 1 } },
  ]

  it.each(rubbed)('only ever takes energy with rk4 and located stops: $scene', (experiment) => {
    const run = simulate({ ...experiment, integrator: 'rk4', frames: { kind: 'steady', fps: 240 } })
    const energy = mechanicalEnergy(run)
    // rk4's own energy error in a step of 1/240 s is some (ωΔt)⁶/72, and ω is at most 7/s here.
    const allowed = (7 / 240) ** 6 * Math.abs(energy[0]!) + 1e-13
    for (let row = 1; row <= run.frames; row++)
      expect(energy[row]! - energy[row - 1]!).toBeLessThanOrEqual(allowed)
  })

  it.each(stoppings.map(({ id }) => id))('heat never falls, with %s stops', (stopping) => {
    for (const experiment of rubbed)
      for (const { id } of integrators) {
        const { heat, frames } = simulate({ ...experiment, integrator: id, stopping })
        for (let row = 1; row <= frames; row++) expect(heat[row]! >= heat[row - 1]!).toBe(true)
      }
  })

  it('makes as much heat as energy goes, to rounding, where the motion is exact', () => {
    const run = simulate(rubbed[0]!)
    expect(run.outcome.kind).toBe('at-rest')
    for (const residual of energyResidual(run)) expect(Math.abs(residual)).toBeLessThan(1e-12)
  })

  it('leaves a residual that falls with the order of the method', () => {
    const residual = (integrator: IntegratorId, fps: number) => {
      const run = simulate({
        ...rubbed[2]!,
        integrator,
        duration: 3,
        frames: { kind: 'steady', fps },
      })
      return Math.abs(energyResidual(run)[run.frames]!)
    }
    expect(
      Math.log2(residual('velocity-verlet', 60) / residual('velocity-verlet', 120)),
    ).toBeCloseTo(2, 0)
    expect(Math.log2(residual('rk4', 60) / residual('rk4', 120))).toBeGreaterThan(3.5)
  })

  it('shows a method that invents energy', () => {
    const run = simulate({ ...rubbed[2]!, integrator: 'explicit-euler', duration: 3 })
    expect(energyResidual(run)[run.frames]!).toBeGreaterThan(0.1)
  })
})
