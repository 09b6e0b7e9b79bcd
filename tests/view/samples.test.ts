import { describe, expect, test } from 'vitest'
import { exactMotion } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { samplesOf } from '../../src/view/samples.ts'

const free = { muStatic: 0, muKinetic: 0 }

const motions: [string, Experiment, number][] = [
  [
    'a kick that is over in the first thousandth',
    { scene: 'ramp', parameters: { speed: -5 } },
    600,
  ],
  ['a pipe', { scene: 'half-pipe' }, 10],
  ['a pipe for ten minutes', { scene: 'half-pipe', parameters: free }, 590],
  ['a spring', { scene: 'spring' }, 60],
  [
    // Its swings and the intervals that every motion is looked at in are in step.
    'a spring that swings 64 times',
    { scene: 'spring', parameters: { ...free, mass: 1, stiffness: (64 * 2 * Math.PI) ** 2 } },
    1,
  ],
  ['a run-out', { scene: 'run-out' }, 20],
  ['a fall with drag', { scene: 'fall', parameters: { drag: 0.3 } }, 60],
]

describe.each(motions)('%s', (_, experiment, duration) => {
  const exact = exactMotion(experiment)
  const { time, s, v, followed } = samplesOf(exact, duration)

  test('begins at 0, ends with the duration, and never goes back', () => {
    expect(time[0]).toBe(0)
    expect(time.at(-1)).toBe(duration)
    expect(time.every((each, row) => row === 0 || each > time[row - 1]!)).toBe(true)
  })

  test('is followed to the end by lines that cannot be told from it', () => {
    expect(followed).toBe(time.length - 1)
    const range = (values: Float64Array) => Math.max(...values) - Math.min(...values)
    // Tried at two places of each line to 1/500; a parabola strays by a seventeenth more in the middle, and by up to twice
    // as much where it has a bend between two lines of the track.
    const [nearS, nearV] = [range(s) / 250, range(v) / 250]
    let row = 0
    for (let i = 0; i <= 50_000; i++) {
      const t = (duration * i) / 50_000
      while (time[row + 1]! < t) row++
      const part = (t - time[row]!) / (time[row + 1]! - time[row]!)
      const state = exact(t, { s: 0, v: 0 })
      const onLine = (values: Float64Array) =>
        values[row]! + part * (values[row + 1]! - values[row]!)
      if (Math.abs(onLine(s) - state.s) > nearS) expect(onLine(s)).toBeCloseTo(state.s, 9)
      if (Math.abs(onLine(v) - state.v) > nearV) expect(onLine(v)).toBeCloseTo(state.v, 9)
    }
  })
})

test('of more swings than can be followed it still shows how far they go', () => {
  const parameters = { ...free, angle: 0, position: 1, stiffness: 14_400 }
  const exact = exactMotion({ scene: 'spring', parameters })
  const { time, s, followed } = samplesOf(exact, 590)
  expect(followed).toBeLessThan(time.length - 1)
  // Four thousand places at random in its swings: all but one in e¹⁶ such sets have one within 1/250 of a turn.
  const near = 1 - Math.cos((2 * Math.PI) / 250)
  const rest = s.subarray(followed + 1)
  expect(Math.max(...rest)).toBeGreaterThan(1 - near)
  expect(Math.min(...rest)).toBeLessThan(near - 1)
})

test('what has no number is not looked for', () => {
  const { time, followed } = samplesOf((_, state) => Object.assign(state, { s: NaN, v: NaN }), 1)
  expect([time.length, followed]).toEqual([65, 64])
})
