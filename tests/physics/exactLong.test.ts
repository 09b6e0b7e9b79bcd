import { describe, expect, it } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { ExactMotion, Scene } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'

const pipe: Scene = scenes.find(({ id }) => id === 'half-pipe')!
const bare = { gravity: 9.81, mass: 1, muStatic: 0, muKinetic: 0, speed: 0 }
const halfPipe = (given: object) => pipe.exact({ radius: 2, ...bare, ...given })
const at = (motion: ExactMotion, t: number) => motion(t, { s: NaN, v: NaN })

describe('thousands of swings with hardly any friction', () => {
  it('lose hardly any energy in 1 000 s', () => {
    const motion = halfPipe({ position: 3.1, muKinetic: 1e-9 })
    const end = samples(1_000)
    for (let i = 0; i <= 2 * end; i++) at(motion, i / 2)
    // It loses 2 μ g · 1 000 s · 5 m/s at most of its 30 J/kg.
    expect(Math.abs(at(motion, end).v)).toBeLessThan(10)
    expect(Math.abs(at(motion, 1).s - at(halfPipe({ position: 3.1 }), 1).s)).toBeLessThan(1e-7)
  })

  it('are given up beyond 1e10 of them without hanging, which the state says', () => {
    const motion = halfPipe({ radius: 0.001, gravity: 1e6, position: 0.001, muKinetic: 1e-300 })
    expect(at(motion, 1e6)).toEqual({ s: NaN, v: NaN })
    expect(at(motion, 0)).toEqual({ s: 0.001, v: 0 })
  })
})
