/**
 * A block that is just as fast as its belt for an instant: it rides for a moment, within a step that begins and ends with
 * slipping.
 */
import { describe, expect, it } from 'vitest'
import { exact, integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { last } from './truth.ts'

const [stiffness, gravity, mu] = [100, 10, 0.4]
const omega = Math.sqrt(stiffness)

/** From rest, so far out that the block gets faster than a belt of that speed, if there were no end to slipping, by `excess`. */
function touching(beltSpeed: number, excess: number): Experiment {
  const direction = Math.sign(beltSpeed)
  const balance = (direction * mu * gravity) / stiffness
  const position = balance - direction * ((Math.abs(beltSpeed) + excess) / omega)
  const parameters = { beltSpeed, stiffness, gravity, mass: 1, position, speed: 0 }
  return {
    ...{ scene: 'belt', duration: 0.4 },
    parameters: { ...parameters, muStatic: mu, muKinetic: mu },
  }
}

function errorAt(fps: number, beltSpeed: number, excess: number): number {
  const experiment = touching(beltSpeed, excess)
  const { s } = simulate({ ...experiment, integrator: 'rk8', frames: { kind: 'steady', fps } })
  return Math.abs(last(s) - exact(experiment, 0.4).s)
}

const excesses = [-1e-6, -1e-9, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1]

describe.each([0.7, -0.7, 2])('a belt of %d m/s', (beltSpeed) => {
  it.each(excesses)('is met by a block that would be faster by %d m/s', (excess) => {
    // The method's error in a swing as long, without a touch; the touch cuts a step in two more.
    for (const fps of [9, 20, 60, 144])
      expect(errorAt(fps, beltSpeed, excess), String(fps)).toBeLessThan(
        2 * errorAt(fps, beltSpeed, -1e-3) + 1e-12,
      )
  })

  it.each(excesses)('to a tolerance, too, by %d m/s', (excess) => {
    const experiment = touching(beltSpeed, excess)
    const truth = exact(experiment, 0.4).s
    for (const { id: integrator } of integrators.filter(({ order }) => order >= 4)) {
      const frames = { kind: 'hitch', fps: 60, every: 0.1, length: 0.1 } as const
      const timestep = { kind: 'tolerance', tolerance: 1e-9 } as const
      const { s } = simulate({ ...experiment, integrator, frames, timestep })
      // Less than half a second of it, at a condition of ten.
      expect(Math.abs(last(s) - truth), integrator).toBeLessThan(1e-8)
    }
  })
})
