/** A belt without a spring, and one on which a block swings for very long. */
import { describe, expect, it } from 'vitest'
import { exact, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { last } from './truth.ts'

const loose = { stiffness: 0, gravity: 10, muStatic: 0.5, muKinetic: 0.4, position: 1 }

describe.each([2, -2])('a belt without a spring, at %d m/s', (beltSpeed) => {
  it.each([0, 1, -1, 6, -6])('takes a block along that comes at %d m/s', (speed) => {
    const experiment: Experiment = { scene: 'belt', parameters: { ...loose, beltSpeed, speed } }
    // Friction alone, 4 m/s², evens out the difference; then the block rides.
    const lasts = Math.abs(beltSpeed - speed) / 4
    const at = (t: number) => {
      const slid = Math.min(t, lasts)
      const s = 1 + speed * slid + 2 * Math.sign(beltSpeed - speed) * slid ** 2
      return s + beltSpeed * (t - slid)
    }
    for (const t of [0.1, lasts, 3]) expect(exact(experiment, t).s).toBeCloseTo(at(t), 12)
    expect(exact(experiment, 3).v).toBe(beltSpeed)
    const run = simulate({ ...experiment, duration: 3 })
    expect(last(run.s)).toBeCloseTo(at(3), 12)
    expect(last(run.v)).toBe(beltSpeed)
  })

  it('without friction leaves it alone', () => {
    const parameters = { ...loose, muStatic: 0, muKinetic: 0, beltSpeed, speed: 3 }
    expect(exact({ scene: 'belt', parameters }, 2)).toMatchObject({ s: 7, v: 3 })
    expect(last(simulate({ scene: 'belt', parameters, duration: 2 }).s)).toBeCloseTo(7, 12)
  })
})

it('the exact motion says that it does not know, after thousands of swings', () => {
  const parameters = { stiffness: 100, muStatic: 1e-7, muKinetic: 1e-7, position: 10, speed: 0 }
  const experiment: Experiment = { scene: 'belt', parameters: { ...parameters, beltSpeed: 0.1 } }
  expect(exact(experiment, 100).s).not.toBeNaN()
  expect(() => exact(experiment, 1e6)).toThrow(/not known to 1e-11 at 1000000 s/)
})
