import { describe, expect, it } from 'vitest'
import { Random } from '../../src/physics/random.ts'
import { sinCos, sinCosDegrees } from '../../src/physics/trigonometry.ts'
import { cosineOf, radiansOf, sineOf, ulpsBetween } from './bigTrigonometry.ts'

/** Angles over a range: a grid that hits its ends, chance, and the neighbours of multiples of 45°. */
function angles(range: number): number[] {
  const random = new Random(1)
  const list = [0, 1e-300, 1e-20, 1e-9]
  for (let i = 0; i <= 500; i++) list.push((i / 500) * range)
  for (let i = 0; i < 1500; i++) list.push((random.next() / 2 ** 32) * range)
  for (let i = 1; i <= 8; i++) {
    const corner = (i * Math.PI) / 4
    for (const near of [
      corner,
      corner * (1 + Number.EPSILON),
      corner * (1 - Number.EPSILON),
      corner + 1e-9,
    ])
      if (near <= range) list.push(near)
  }
  return list
}

describe('sine and cosine', () => {
  it('are within 1 ulp of the true value over two turns, a pipe and all its trial steps', () => {
    for (const angle of angles(4 * Math.PI)) {
      const { sin, cos } = sinCos(angle)
      expect(ulpsBetween(sin, sineOf(angle)), `sin ${angle}`).toBeLessThanOrEqual(1)
      expect(ulpsBetween(cos, cosineOf(angle)), `cos ${angle}`).toBeLessThanOrEqual(1)
    }
  })

  it('are odd and even to the bit', () => {
    for (const angle of angles(7).filter((angle) => angle > 0)) {
      const there = sinCos(angle)
      const mirrored = sinCos(-angle)
      expect(mirrored.sin).toBe(-there.sin)
      expect(mirrored.cos).toBe(there.cos)
    }
  })

  it('stay numbers between −1 and 1 however far a diverged step asks', () => {
    for (const angle of [1e5, 1e8, 1e9, 1e15, 1e300]) {
      const { sin, cos } = sinCos(angle)
      expect(Math.abs(sin)).toBeLessThanOrEqual(1)
      expect(Math.abs(cos)).toBeLessThanOrEqual(1)
    }
    for (const angle of [NaN, Infinity, -Infinity]) {
      expect(sinCos(angle).sin).toBeNaN()
      expect(sinCos(angle).cos).toBeNaN()
    }
  })

  it('of degrees are within 1 ulp from −90° to 90°, and exact at the ends', () => {
    const random = new Random(2)
    for (let i = 0; i <= 2000; i++) {
      const degrees = i <= 180 ? i - 90 : (random.next() / 2 ** 31 - 1) * 90
      const { sin, cos } = sinCosDegrees(degrees)
      expect(ulpsBetween(sin, sineOf(radiansOf(degrees))), `sin ${degrees}°`).toBeLessThanOrEqual(1)
      if (Math.abs(degrees) < 90)
        expect(
          ulpsBetween(cos, cosineOf(radiansOf(degrees))),
          `cos ${degrees}°`,
        ).toBeLessThanOrEqual(1)
    }
    expect(sinCosDegrees(90)).toMatchObject({ sin: 1, cos: 0 })
    expect(sinCosDegrees(0)).toMatchObject({ sin: 0, cos: 1 })
    expect(sinCosDegrees(-90)).toMatchObject({ sin: -1, cos: 0 })
  })
})
