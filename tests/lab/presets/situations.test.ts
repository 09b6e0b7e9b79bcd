import { expect, test } from 'vitest'
import { simulate } from '../../../src/physics/index.ts'
import type { Trajectory } from '../../../src/physics/index.ts'
import { experimentOf } from '../../../src/lab/state/check.ts'
import { presets } from '../../../src/lab/presets/index.ts'

const runsOf = (label: string): Trajectory[] => {
  const { state } = presets.find((each) => each.label === label)!.shown
  return state.runners.map((runner) => simulate(experimentOf(state, runner)))
}
const kinds = (runs: readonly Trajectory[]) => runs.map(({ outcome }) => outcome.kind)

test('just fast enough: all but 10 fps take off, located where the top begins', () => {
  const runs = runsOf('Just fast enough to take off')
  const left = 'left-the-track'
  expect(kinds(runs)).toEqual(['moving', left, left, left])
  expect(runs[3]!.s.at(-1)).toBeCloseTo(0, 12)
})

test('just too slow: nobody takes off', () => {
  expect(new Set(kinds(runsOf('Just too slow to take off')))).toEqual(new Set(['moving']))
})

test('fast enough by far: all take off, the fewer the frames the later', () => {
  const runs = runsOf('Fast enough by far')
  expect(new Set(kinds(runs))).toEqual(new Set(['left-the-track']))
  const times = runs.map(({ outcome }) => outcome.time)
  expect([...times].sort((a, b) => b - a)).toEqual(times)
  expect(times[0]! - times[3]!).toBeLessThan(0.1)
})

test('a smooth dome is left where the cosine is two thirds', () => {
  const [slow, , toTolerance] = runsOf('Off a smooth dome')
  const angle = (run: Trajectory) => (run.s.at(-1)! / 3) * (180 / Math.PI) - 75
  // The little speed that it starts with makes it leave a little earlier.
  const cosine = (2 + 0.05 ** 2 / (9.81 * 3)) / 3
  expect(angle(toTolerance!)).toBeCloseTo((Math.acos(cosine) * 180) / Math.PI, 2)
  expect(angle(slow!)).toBeGreaterThan(50)
})

test('a tolerance that can’t be met ends that run alone', () => {
  const [naive, located] = runsOf('A tolerance that can’t be met')
  expect([naive!.outcome.kind, naive!.abandoned]).toEqual(['diverged', true])
  expect([located!.outcome.kind, located!.abandoned]).toEqual(['at-rest', false])
})

test('in the half-pipe all are within a micrometre of each other', () => {
  const ends = runsOf('Three frame rates in a half-pipe').map(({ s }) => s.at(-1)!)
  expect(Math.max(...ends) - Math.min(...ends)).toBeLessThan(1e-6)
})
