import { describe, expect, it } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { Scene } from '../../src/physics/index.ts'

const pipe: Scene = scenes.find(({ id }) => id === 'half-pipe')!

describe('the place of a block that a coarse step has carried past the lip', () => {
  it.each([-1, 1])('lies on the circle still, on the side %i', (side) => {
    const radius = 2
    const s = side * (Math.PI / 2 + 0.3) * radius
    const { x, y, slope, curvature } = pipe.place({ radius }, s)
    // The bottom is the origin, the circle's middle a radius above it.
    expect(x).toBeCloseTo(radius * Math.sin(s / radius), 14)
    expect(y).toBeCloseTo(radius * (1 - Math.cos(s / radius)), 14)
    expect(slope).toBeCloseTo(-s / radius, 14)
    expect(curvature).toBe(1 / radius)
  })
})
