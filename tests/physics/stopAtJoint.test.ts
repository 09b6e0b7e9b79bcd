/** A block that friction stops exactly where its piece of track ends: of two events at once, neither hides the other. */
import { describe, expect, it } from 'vitest'
import { integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { Chance } from './generated.ts'
import { last } from './truth.ts'

const chance = new Chance(1673)

interface Case {
  name: string
  joint: number
  parameters: Record<string, number>
}

const radians = (degrees: number) => (degrees * Math.PI) / 180

const cases: Case[] = [
  // In numbers that are exact: 10²/(2 · ½ · 10) = 10 m.
  {
    name: 'at the end of a slope that is none',
    joint: 10,
    parameters: { angle: 0, length: 10, gravity: 10, muStatic: 0.5, muKinetic: 0.5, speed: 10 },
  },
  ...Array.from({ length: 10 }, () => {
    const [angle, speed] = [chance.between(1, 30), chance.between(1, 10)]
    const muKinetic = Math.tan(radians(angle)) + chance.between(0.3, 1)
    const brake = 9.81 * (muKinetic * Math.cos(radians(angle)) - Math.sin(radians(angle)))
    const length = speed ** 2 / (2 * brake)
    const name = 'at the end of a slope'
    const parameters = { angle, length, muStatic: muKinetic, muKinetic, speed }
    return { name, joint: length, parameters }
  }),
  ...Array.from({ length: 10 }, () => {
    const [angle, speed, mu] = [
      chance.between(1, 80),
      chance.between(1, 10),
      chance.between(0.2, 1),
    ]
    const bendRadius = chance.between(0.5, 3)
    const foot = 2 + bendRadius * radians(angle)
    const position = foot + speed ** 2 / (2 * mu * 9.81)
    const friction = { muStatic: mu, muKinetic: mu }
    const parameters = { angle, length: 2, bendRadius, ...friction, position, speed: -speed }
    return {
      name: 'on its way back over the flat, at the foot of the bend',
      joint: foot,
      parameters,
    }
  }),
]

// Without a force that changes, methods of second order and more are exact to rounding.
const exactMethods = integrators.filter(({ order }) => order >= 2)

describe.each(exactMethods)('with $id', ({ id: integrator }) => {
  it('a block that stops at a joint is at rest there, at any frame rate', () => {
    for (const { name, joint, parameters } of cases)
      for (const fps of [1, 3, 7, 24, 60, 240]) {
        const experiment: Experiment = {
          ...{ scene: 'run-out', parameters, integrator, duration: 6 },
          frames: { kind: 'steady', fps },
        }
        const run = simulate(experiment)
        const where = `${name}: ${JSON.stringify(experiment)}`
        expect(run.outcome.kind, where).toBe('at-rest')
        expect(last(run.v), where).toBe(0)
        // Half an ulp of 20 m, twice, in each of a thousand steps at the most: it stops within 4 s.
        expect(Math.abs(last(run.s) - joint), where).toBeLessThanOrEqual(4e-12)
      }
  })
})
