import { readFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { describe, expect, it } from 'vitest'
import { step } from '../../src/tutorial/take-home/step.ts'
import { cases, furthestOff } from './take-home/cases.ts'
import type { Row } from './take-home/cases.ts'

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

describe('the four files', () => {
  const folder = resolve(import.meta.dirname, '../../src/tutorial/take-home')
  const comments = (file: string) =>
    [...readFileSync(join(folder, file), 'utf8').matchAll(/^\s*(?:\/\/|#) (\d\. .+)$/gm)].map(
      ([, text]) => text,
    )

  it.each(['step.cpp', 'Step.cs', 'step.gd'])('%s has the same six parts as step.ts', (file) => {
    expect(comments('step.ts').map((text) => text![0])).toEqual(['1', '2', '3', '4', '5', '6'])
    expect(comments(file)).toEqual(comments('step.ts'))
  })

  it.each(['step.ts', 'step.cpp', 'Step.cs', 'step.gd'])(
    '%s stays within 50 lines that fit a narrow column',
    (file) => {
      const lines = readFileSync(join(folder, file), 'utf8').trimEnd().split('\n')
      expect(lines.length).toBeLessThanOrEqual(50)
      for (const line of lines) expect(line.length).toBeLessThanOrEqual(90)
    },
  )
})
