import { describe, expect, it } from 'vitest'
import { bytesOf } from '../../src/report/timing/bytes.ts'
import { median, ratioOf, timeRounds, timingOf } from '../../src/report/timing/rounds.ts'
import { notes } from '../../src/report/engines/run.ts'
import { engineScenes } from '../../src/report/engines/scenes.ts'
import { eachInMetres, inMetres, nanoseconds, plainNumber } from '../../src/report/text/numbers.ts'

describe('rounds', () => {
  it('are as many as asked for, of each work, prepared before each run', () => {
    let prepared = 0
    let runs = 0
    const work = { units: 10, prepare: () => prepared++, run: () => ++runs }
    const times = timeRounds([work, work], { rounds: 4, atLeast: 0.01, warming: 0.01 })
    expect(times.map((each) => each.length)).toEqual([4, 4])
    expect(prepared).toBe(runs)
    expect(runs).toBeGreaterThanOrEqual(10)
    for (const time of times.flat()) expect(time).toBeGreaterThan(0)
  })

  it('a work that comes to no number is noticed', () => {
    const care = { rounds: 1, atLeast: 0.001, warming: 0.001 }
    expect(() => timeRounds([{ units: 1, run: () => NaN }], care)).toThrow('no number')
  })

  it('come to a median, a spread, and a ratio of the same rounds', () => {
    expect(median([3, 1, 2])).toBe(2)
    expect(median([4, 1, 2, 3])).toBe(2.5)
    expect(timingOf([5, 1, 9])).toEqual({ median: 5, least: 1, most: 9 })
    // The machine was three times as busy in the second round: the ratio does not see it.
    expect(ratioOf([2, 6, 2], [1, 3, 1])).toBe(2)
  })
})

it('bytes are counted: a boxed number for each unit, and none for none', () => {
  const kept: { boxed: number }[] = []
  const boxing = {
    units: 200_000,
    run: () => {
      for (let i = 0; i < 200_000; i++) kept[i & 1023] = { boxed: i + 0.5 }
      return kept.length
    },
  }
  // An object with a number takes 12 bytes at least; what the engine takes on the side is far less.
  expect(bytesOf(boxing)).toBeGreaterThan(12)
  expect(bytesOf({ units: 1e6, run: () => 0 })).toBeLessThan(1)
})

it('figures are given with three digits at most', () => {
  expect(inMetres(0.32146)).toBe('0.321\u202fm')
  expect(inMetres(-0.0537)).toBe('0.0537\u202fm')
  expect(inMetres(0)).toBe('0')
  expect(inMetres(null)).toBe('no number')
  expect(inMetres(8.88e-16)).toBe('0 (to rounding)')
  expect(inMetres(1e-8)).toBe('10\u202fnm')
  expect(inMetres(1e-6)).toBe('1\u202fµm')
  expect(eachInMetres([0, 0])).toBe('0')
  expect(eachInMetres([0, 1e-15])).toBe('0 (to rounding)')
  expect(eachInMetres([0, 0.5, null])).toBe('0, 0.5\u202fm, no number')
  expect(nanoseconds(5.123)).toBe('5.12\u202fns')
  expect(nanoseconds(12345)).toBe('12.3\u202fµs')
  expect(nanoseconds(4.5e6)).toBe('4.5\u202fms')
  expect(plainNumber(14062)).toBe('14\u202f062')
  expect(plainNumber(2.2e12)).toBe('2.2\u202f×\u202f10¹²')
  expect(plainNumber(-2e-5)).toBe('−2\u202f×\u202f10⁻⁵')
  expect(plainNumber(0.125)).toBe('0.125')
})

it('what is odd about a run is said with its numbers', () => {
  const scene = (id: string) => engineScenes.find((each) => each.id === id)!
  const fine = { position: -1.5, late: -1.5, lifted: 0, later: -1.5 }
  expect(notes(scene('uphill-stays'), fine)).toBeNull()
  expect(notes(scene('uphill-stays'), { ...fine, later: -1.25 })).toBe(
    'creeps 0.25\u202fm while it should rest',
  )
  expect(notes(scene('under'), { ...fine, position: 4, late: 3.5, later: null })).toBe(
    'still moves: 0.5\u202fm in the last 6\u202fs',
  )
  expect(notes(scene('slide'), { ...fine, later: null })).toBe(
    'at rest at 1.5\u202fm, where nothing holds it',
  )
  expect(notes(scene('slide'), { position: 6, late: 5, lifted: -2, later: null })).toBe(
    '2\u202fm off the slope',
  )
  expect(notes(scene('slide'), { position: NaN, late: 5, lifted: 0, later: null })).toBe(
    'ended as no number',
  )
})
