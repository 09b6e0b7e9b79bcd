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

describe.each(scenes)('the places of $id', (scene: Scene) => {
  const parameters = Object.fromEntries(
    Object.entries(scene.parameters).map(([name, { initial }]) => [name, initial]),
  )
  const place = (s: number) => scene.place(parameters, s)

  it('lie along the slope that each tells of, which bends as it says', () => {
    const h = 1e-5
    // On the slope, on the bend and on the flat of a run-out; within the lips of a pipe.
    for (const s of [-2.7, -0.4, 0.6, 1.9, 3, 4.2, 4.7, 6].filter(
      (s) => scene.id !== 'half-pipe' || Math.abs(s) < 3,
    )) {
      const { slope, curvature } = place(s)
      const [before, after] = [place(s - h), place(s + h)]
      // Central differences: (h κ)²/6 of their size, and an ulp of 8 m over 2h.
      expect((after.x - before.x) / (2 * h)).toBeCloseTo(Math.cos(slope), 9)
      expect((after.y - before.y) / (2 * h)).toBeCloseTo(-Math.sin(slope), 9)
      expect((before.slope - after.slope) / (2 * h)).toBeCloseTo(curvature, 9)
    }
  })

  it('begin at the origin where s does, and the potential is g times their height', () => {
    const { x, y } = place(0)
    expect([x, y].map(Math.abs)).toEqual([0, 0])
    for (const s of [-2, 0.5, 2.9, 4.4, 7]) {
      const spring = 0.5 * (parameters.stiffness ?? 0) * s * s
      const height = scene.potential(parameters, s) - spring - scene.potential(parameters, 0)
      expect(height).toBeCloseTo(9.81 * place(s).y, 12)
    }
  })
})

describe('the place at a joint', () => {
  it('is on the piece that ends there', () => {
    const runOut: Scene = scenes.find(({ id }) => id === 'run-out')!
    const parameters = { angle: 30, length: 4, bendRadius: 1.5 }
    const end = 4 + (1.5 * Math.PI) / 6
    expect(runOut.place(parameters, 4).curvature).toBe(0)
    expect(runOut.place(parameters, 4 + 1e-9).curvature).toBe(1 / 1.5)
    expect(runOut.place(parameters, end - 1e-9).curvature).toBe(1 / 1.5)
    expect(runOut.place(parameters, end + 1e-9).curvature).toBe(0)
  })
})
