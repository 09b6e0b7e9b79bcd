/** Left and right are alike: where a scene is its own mirror image, a mirrored start gives the mirrored motion. */
import { describe, expect, it } from 'vitest'
import { integrators, simulate, stoppings } from '../../src/physics/index.ts'
import type { Experiment, Parameters } from '../../src/physics/index.ts'

const level = { angle: 0, muStatic: 0.3, muKinetic: 0.2 }

const mirrored: { name: string; experiment: Experiment; signed: readonly string[] }[] = [
  {
    name: 'a level slope',
    experiment: { scene: 'ramp', parameters: { ...level, position: 1, speed: 3 } },
    signed: ['position', 'speed'],
  },
  {
    name: 'a level spring',
    experiment: { scene: 'spring', parameters: { ...level, position: 1.3, speed: 2 } },
    signed: ['position', 'speed'],
  },
  {
    name: 'a pipe with friction',
    experiment: {
      scene: 'half-pipe',
      parameters: { position: 1.6, speed: 1, muStatic: 0.2, muKinetic: 0.1 },
    },
    signed: ['position', 'speed'],
  },
  {
    name: 'a pipe that is left',
    experiment: { scene: 'half-pipe', parameters: { position: 1, speed: 6 } },
    signed: ['position', 'speed'],
  },
  {
    name: 'a belt on which the block rides, slips and sticks',
    experiment: { scene: 'belt', parameters: { beltSpeed: 0.4, position: 0.05 } },
    signed: ['beltSpeed', 'position', 'speed'],
  },
  {
    name: 'a belt that overtakes the block',
    experiment: { scene: 'belt', parameters: { beltSpeed: 2, position: 0.1, speed: -1 } },
    signed: ['beltSpeed', 'position', 'speed'],
  },
  {
    name: 'a belt that the block overtakes',
    experiment: { scene: 'belt', parameters: { beltSpeed: 0.3, position: -1, speed: 2 } },
    signed: ['beltSpeed', 'position', 'speed'],
  },
]

function mirror(parameters: Parameters, signed: readonly string[]): Parameters {
  return Object.fromEntries(
    Object.entries(parameters).map(([key, value]) => [key, signed.includes(key) ? -value : value]),
  )
}

describe.each(mirrored)('$name', ({ experiment, signed }) => {
  it.each(integrators)('moves alike either way, to the bit, with $id', ({ id: integrator }) => {
    for (const { id: stopping } of stoppings) {
      const one = { ...experiment, integrator, stopping, duration: 3 } as Experiment
      const parameters = mirror(experiment.parameters as Parameters, signed)
      const [a, b] = [simulate(one), simulate({ ...one, parameters })]
      expect(b.s.map((s) => 0 - s)).toEqual(a.s.map((s) => s + 0))
      expect(b.v.map((v) => 0 - v)).toEqual(a.v.map((v) => v + 0))
      expect(b.heat).toEqual(a.heat)
      expect(b.outcome).toEqual(a.outcome)
    }
  })
})
