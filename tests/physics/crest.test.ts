/** Taking off from a crest: where press, g cos θ − v²/R, is 0. */
import { describe, expect, it } from 'vitest'
import { exact, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { radians } from '../../src/physics/trigonometry.ts'
import { last } from './truth.ts'

const smooth = { muStatic: 0, muKinetic: 0 }

/** From the top of a crest of radius R that slopes by 60° at its ends, without friction. */
function fromTop(crestRadius: number, speed: number): Experiment {
  const position = crestRadius * radians(60)
  const parameters = { ...smooth, angle: 60, crestRadius, position, speed, gravity: 9 }
  return { scene: 'crest', parameters, integrator: 'rk8', duration: 5 }
}

describe('a block that slides over the top', () => {
  it.each([
    [1, 0.5],
    [2, 1],
    [3, -1.5],
  ])('of radius %d m at %d m/s takes off where its energy says', (R, speed) => {
    // ½v² = ½v₀² + gR (1 − cos θ) and v² = gR cos θ.
    const cosine = (2 + speed ** 2 / (9 * R)) / 3
    const place = R * (radians(60) + Math.sign(speed) * Math.acos(cosine))
    const fast = Math.sign(speed) * Math.sqrt(9 * R * cosine)
    const truth = exact(fromTop(R, speed), 5)
    expect(truth.s).toBeCloseTo(place, 11)
    expect(truth.v).toBeCloseTo(fast, 11)
    const run = simulate(fromTop(R, speed))
    expect(run.outcome.kind).toBe('left-the-track')
    expect(last(run.s)).toBeCloseTo(place, 9)
    expect(last(run.v)).toBeCloseTo(fast, 9)
  })

  it('as fast as the top just bears takes off there', () => {
    const run = simulate(fromTop(1, 3))
    expect(run.outcome).toEqual({ kind: 'left-the-track', time: 0 })
    expect(last(run.s)).toBe(radians(60))
  })

  it.each(['naive', 'clamped', 'located'] as const)('faster is never on it, %s', (stopping) => {
    const run = simulate({ ...fromTop(1, 3.1), stopping })
    expect(run.outcome).toEqual({ kind: 'left-the-track', time: 0 })
    expect(last(run.v)).toBe(3.1)
    expect(exact(fromTop(1, 3.1), 1)).toMatchObject({ s: radians(60), v: 3.1 })
  })
})
