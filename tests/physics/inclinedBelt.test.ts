/** A belt that runs down a slope, which no scene has: static friction then balances the spring and gravity. */
import { expect, it } from 'vitest'
import { rk8 } from '../../src/physics/integrators/rk8.ts'
import { lawOf } from '../../src/physics/law.ts'
import { Motion } from '../../src/physics/motion.ts'
import { advance } from '../../src/physics/step.ts'
import { located } from '../../src/physics/stopping/located.ts'
import { straight } from '../../src/physics/track.ts'
import { radians } from '../../src/physics/trigonometry.ts'

const [gravity, stiffness, muStatic, muKinetic] = [10, 40, 0.5, 0.3]

it.each([
  [10, 0.4],
  [30, 0.4],
  [60, 0.4],
  [10, -0.4],
  [30, -0.4],
  [60, -0.4],
])(
  'a block on a belt at %d° and %d m/s rides up to where static friction gives way',
  (angle, u) => {
    const [pull, press] = [gravity * Math.sin(radians(angle)), gravity * Math.cos(radians(angle))]
    const release = (pull + Math.sign(u) * muStatic * press) / stiffness
    const start = release - 0.15 * u
    const law = lawOf([straight(angle)], {
      ...{ gravity, stiffness, muStatic, muKinetic, beltSpeed: u, position: start, speed: u },
    })
    const motion = new Motion(law, start, u, true)
    const energy = () =>
      0.5 * motion.v ** 2 + 0.5 * stiffness * motion.s ** 2 - pull * motion.s - motion.work
    const before = energy()

    motion.dt = 0.1
    advance(motion, rk8, located)
    expect(motion.s).toBeCloseTo(start + 0.1 * u, 12)
    expect(motion.v).toBe(u)
    expect(motion.heat).toBe(0)
    expect(energy()).toBeCloseTo(before, 12)

    // After 0.05 s it is torn off: it is slower than the belt, and friction heats it.
    advance(motion, rk8, located, true)
    expect(motion.outcome).toBe('moving')
    expect(motion.dt).toBeCloseTo(0.05, 12)
    expect(motion.v).toBe(u)
    motion.dt = 0.05
    advance(motion, rk8, located)
    expect(Math.sign(u) * (u - motion.v)).toBeGreaterThan(0)
    expect(motion.heat).toBeGreaterThan(0)
    expect(energy() + motion.heat).toBeCloseTo(before, 9)
  },
)
