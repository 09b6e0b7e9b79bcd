import { expect, test } from 'vitest'
import { simulate } from '../../src/physics/index.ts'
import type { Experiment, Trajectory } from '../../src/physics/index.ts'
import { blend } from '../../src/lab/glide.ts'

const kick: Experiment = { scene: 'ramp', parameters: { speed: -5 }, duration: 2 }
const from = simulate({ ...kick, stopping: 'naive', integrator: 'semi-implicit-euler' })
const to = simulate(kick)

test('it begins as the one and ends as the other', () => {
  for (const column of ['s', 'drawnS'] as const) {
    expect(blend(from, to, 0)[column]).toEqual(from[column])
    expect(blend(from, to, 1)[column]).toEqual(to[column])
    expect(blend(from, to, 0.25)[column][20]).toBeCloseTo(
      0.75 * from[column][20]! + 0.25 * to[column][20]!,
      12,
    )
  }
})

test('only the places that are drawn are on their way', () => {
  const { s, drawnS } = to
  expect({ ...blend(from, to, 0.5), s, drawnS }).toEqual(to)
})

test('a run that ended early stays where it ended', () => {
  const short: Trajectory = { ...from, s: from.s.slice(0, 5), drawnS: from.drawnS.slice(0, 5) }
  const { drawnS } = blend(short, to, 0)
  expect(drawnS.length).toBe(to.drawnS.length)
  expect(drawnS.at(-1)).toBe(from.drawnS[4])
})

test('places that are too far apart for a number are none the less blended', () => {
  const far = (s: number): Trajectory => ({
    ...to,
    s: to.s.map(() => s),
    drawnS: to.s.map(() => s),
  })
  expect(blend(far(1.5e308), far(-1.5e308), 0.5).drawnS[0]).toBe(0)
})
