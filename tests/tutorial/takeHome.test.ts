import { readdirSync, readFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { describe, expect, it } from 'vitest'
import { step } from '../../src/tutorial/take-home/step.ts'
import { cases, furthestOff } from './take-home/cases.ts'
import type { Row } from './take-home/cases.ts'
import { cases3d, furthestOff3d } from './take-home/cases3d.ts'
import type { Triple } from './take-home/cases3d.ts'
import { slid } from './take-home/slid.ts'

const vector = ([x, y]: readonly [number, number]) => ({ x, y })

describe('the step to take home', () => {
  it.each(cases)('is simulate’s own motion: $name', (one) => {
    const { gravity, normal, along, muStatic, muKinetic, speed, frames } = one
    const body = {
      position: { x: 0, y: 0 },
      velocity: { x: along[0] * speed, y: along[1] * speed },
    }
    const rows = frames.map((dt): Row => {
      step(body, dt, vector(gravity), vector(normal), muStatic, muKinetic)
      return [body.position.x, body.position.y, body.velocity.x, body.velocity.y]
    })
    // Some ten roundings of 1.1e-16 a frame, of 288 frames at the most.
    expect(furthestOff(one, rows)).toBeLessThan(1e-12)
  })

  it('comes to rest exactly, and stays there to the bit', () => {
    const body = { position: { x: 0, y: 0 }, velocity: { x: 4, y: 0 } }
    const once = () => step(body, 0.1, { x: 0, y: -9.81 }, { x: 0, y: 1 }, 0.5, 0.5)
    for (let i = 0; i < 10; i++) once()
    expect(body.velocity).toEqual({ x: 0, y: -0 })
    const { position } = body
    once()
    expect(body.position).toEqual(position)
    // v²/2μg.
    expect(position.x).toBeCloseTo(16 / 9.81, 12)
  })

  it('works with y downwards too', () => {
    const up = { position: { x: 0, y: 0 }, velocity: { x: 3, y: 1 } }
    const down = { position: { x: 0, y: 0 }, velocity: { x: 3, y: -1 } }
    for (let i = 0; i < 20; i++) {
      step(up, 0.03, { x: 0, y: -9.81 }, { x: 0.6, y: 0.8 }, 0.4, 0.3)
      step(down, 0.03, { x: 0, y: 9.81 }, { x: 0.6, y: -0.8 }, 0.4, 0.3)
    }
    expect(down.position.x).toBeCloseTo(up.position.x, 12)
    expect(down.position.y).toBeCloseTo(-up.position.y, 12)
  })

  it('ends where there is nothing to do: no time, no gravity, no number', () => {
    const body = { position: { x: 1, y: 2 }, velocity: { x: 0, y: 0 } }
    step(body, 0, { x: 0, y: -9.81 }, { x: 0, y: 1 }, 0, 0)
    step(body, 1, { x: 0, y: 0 }, { x: 0, y: 1 }, 0, 0)
    expect(body.position).toEqual({ x: 1, y: 2 })
    step(body, 1, { x: NaN, y: NaN }, { x: 0, y: 1 }, 0, 0)
    expect(body.position.x).toBeNaN()
  })
})

describe('the step in three dimensions', () => {
  it.each(cases3d)('is within two millimetres of a fine integration: $name', (one) => {
    // A part changes the velocity by a fiftieth, and its error goes with the square of that, over some 5 m.
    expect(furthestOff3d(slid(one), one.rows)).toBeLessThan(0.02 ** 2 * 5)
  })

  it.each(cases)('is that of two dimensions where nothing turns: $name', (one) => {
    const { along, speed, gravity, normal } = one
    const inSpace = ([x, y]: readonly [number, number], factor = 1): Triple => {
      return [factor * x, factor * y, 0]
    }
    const slide = {
      ...{ ...one, gravity: inSpace(gravity), normal: inSpace(normal) },
      velocity: inSpace(along, speed),
    }
    const rows = slid(slide).map(([x, y, z, u, w, q]): Row => {
      expect([Math.abs(z), Math.abs(q)]).toEqual([0, 0])
      return [x, y, u, w]
    })
    // Some hundred parts more than there are frames, each with some ten roundings.
    expect(furthestOff(one, rows)).toBeLessThan(1e-12)
  })

  it('turns a kick across the steepest slope that holds to straight down, at half its speed', () => {
    // v (1 + cos θ) keeps its value there; θ falls by a factor of e in v₀/2g sin α s.
    const angle = Math.atan(0.75)
    const [sin, cos] = [Math.sin(angle), Math.cos(angle)]
    const given = { gravity: [0, -9.81, 0], normal: [sin, cos, 0], velocity: [0, 0, 5] } as const
    const frames = Array.from({ length: 300 }, () => 1 / 30)
    const [, , , u, w, q] = slid({ ...given, muStatic: 0.75, muKinetic: 0.75, frames }).at(-1)!
    expect(q / 5).toBeCloseTo(0, 5)
    expect(Math.hypot(u, w, q)).toBeCloseTo(2.5, 3)
    expect(u).toBeGreaterThan(0)
  })

  it('comes to rest exactly, stays there to the bit, and ends where there is nothing to do', () => {
    const given = {
      gravity: [0, -9.81, 0],
      normal: [0, 1, 0],
      muStatic: 0.5,
      muKinetic: 0.5,
    } as const
    const rows = slid({ ...given, velocity: [3, 0, 4], frames: [0.3, 0.3, 0.6, 0.1, 0, 1] })
    const [x, y, z, ...v] = rows[2]!
    expect(v.map(Math.abs)).toEqual([0, 0, 0])
    for (const row of rows.slice(3)) expect(row.slice(0, 3)).toEqual([x, y, z])
    // v²/2μg, along the kick.
    expect(x).toBeCloseTo((0.6 * 25) / 9.81, 12)
    expect(z).toBeCloseTo((0.8 * 25) / 9.81, 12)
    const nothing = { ...given, velocity: [0, 0, 0], frames: [1] } as const
    expect(slid({ ...nothing, gravity: [0, 0, 0] })[0]!.slice(0, 3)).toEqual([0, 0, 0])
    expect(slid({ ...nothing, gravity: [NaN, NaN, NaN] })[0]![0]).toBeNaN()
  })
})

describe('the files', () => {
  const folder = resolve(import.meta.dirname, '../../src/tutorial/take-home')
  const comments = (file: string) =>
    [...readFileSync(join(folder, file), 'utf8').matchAll(/^\s*(?:\/\/|#) (\d\. .+)$/gm)].map(
      ([, text]) => text,
    )

  it.each([
    ['step.ts', ['step.cpp', 'Step.cs', 'step.gd']],
    ['step3d.ts', ['step3d.cpp', 'Step3D.cs', 'step3d.gd']],
  ])('with the six parts of %s are %j', (first, others) => {
    expect(comments(first).map((text) => text![0])).toEqual(['1', '2', '3', '4', '5', '6'])
    for (const file of others) expect(comments(file)).toEqual(comments(first))
  })

  it.each(readdirSync(folder))('%s stays within 55 lines that fit a narrow column', (file) => {
    const lines = readFileSync(join(folder, file), 'utf8').trimEnd().split('\n')
    expect(lines.length).toBeLessThanOrEqual(55)
    for (const line of lines) expect(line.length).toBeLessThanOrEqual(90)
  })
})
