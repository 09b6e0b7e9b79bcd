import { describe, expect, test } from 'vitest'
import { changed } from '../../../src/lab/state/change.ts'
import { coarseClock } from '../../../src/lab/state/frameTimes.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { experimentsIn, labOf } from '../../../src/lab/state/together.ts'
import { framesBetween, logSummary, stretchOf } from '../../../src/panels/record/logWords.ts'
import { toJson } from '../../../src/panels/share/texts.ts'

const source = { column: 'msBetweenPresents', unit: 'ms', isClock: false, leftOut: 0 } as const

describe('the summary of a log', () => {
  test('says how many frames in what time, from which column and unit, and what is left out', () => {
    const frames = new Float64Array(4265).fill(0.0069)
    frames[7] = 0.1314
    const words =
      '4\u202f265 frames in 29.6 s, median 6.9 ms, longest 131 ms, from msBetweenPresents (in ms)'
    expect(logSummary(frames, source)).toBe(words)
    expect(logSummary(frames, { ...source, leftOut: 3 })).toBe(`${words}; 3 rows left out`)
    expect(logSummary(frames, { ...source, leftOut: 1 })).toBe(`${words}; 1 row left out`)
  })

  test('names a clock as such, and a list without a name', () => {
    const frames = Float64Array.of(0.0004)
    expect(logSummary(frames, { ...source, column: 'Time', unit: 's', isClock: true })).toBe(
      '1 frame in 0.4 ms, median 0.4 ms, longest 0.4 ms, from the differences of Time (in s)',
    )
    expect(logSummary(frames, { ...source, column: '', unit: 'µs' })).toMatch(/from a list in µs$/)
  })
})

describe('a part of a log', () => {
  const stretch = stretchOf(Float64Array.of(0.01, 0.02, 0.03, 0.04))
  test.each([
    [0, 1, [0.01, 0.02, 0.03, 0.04]],
    [0, 0.1, [0.01, 0.02, 0.03, 0.04]],
    [0.01, 0.06, [0.02, 0.03]],
    [0.011, 0.061, [0.03, 0.04]],
    // It holds a frame at least.
    [0.011, 0.012, [0.03]],
    [0.1, 0.1, [0.04]],
  ])('from %d to %d s holds the frames that begin in it', (from, to, frames) => {
    expect([...framesBetween(stretch, from, to, 100)]).toEqual(frames)
  })

  test('ends where the clock takes no more', () => {
    expect([...framesBetween(stretch, 0.01, 1, 2)]).toEqual([0.02, 0.03])
  })
})

describe('a clock that was coarsened', () => {
  const lengths = [16.7, 33.4, 16.6, 16.7, 8.3, 16.7, 16.8, 16.6, 50.1, 16.7, 16.7, 16.9]
  const instants = lengths.map((_, i) =>
    lengths.slice(0, i).reduce((sum, each) => sum + each, 912.4),
  )
  const to = (unit: number) => instants.map((each) => Math.floor(each / unit) * unit)

  test.each([
    [1, 'multiples of 1 ms: the browser has coarsened its clock'],
    [1000 / 60, 'multiples of 16.7 ms: either'],
    [100, 'multiples of 100 ms: the browser has coarsened its clock'],
  ])('to %d ms is noticed', (unit, words) => {
    expect(coarseClock(to(unit))).toContain(words)
    // As a browser writes them, with a few digits.
    expect(coarseClock(to(unit).map((each) => Number(each.toFixed(2))))).toContain(words)
  })

  test('to 0.1 ms is not, and neither are a few frames or a 60 Hz display that is not quite one', () => {
    expect(coarseClock(to(0.1))).toBe('')
    expect(coarseClock(to(1).slice(0, 9))).toBe('')
    expect(coarseClock(Array.from({ length: 300 }, (_, i) => (i * 1000) / 59.94))).toBe('')
  })
})

describe('what was copied as JSON', () => {
  test('comes back, a single experiment and several, with the longest list of frames', () => {
    const durations = Array.from({ length: 100_000 }, (_, i) => (6900 + (i % 97)) / 1e6)
    const many = changed(opening, { kind: 'add', frames: { kind: 'recorded', durations } })
    const one = { ...opening, runners: opening.runners.slice(0, 1) }
    for (const state of [opening, one, many]) {
      const experiments = experimentsIn(toJson(state))!
      const runners = state.runners.map((runner, i) => ({ ...runner, paletteIndex: i }))
      expect(labOf(experiments)).toEqual({ ...state, runners })
    }
  })

  test('is told from a log, and refused with the reason where it can’t be run', () => {
    for (const text of [
      '[16.6, 17]',
      '{"Runs": []}',
      'frametime\n16',
      '[]',
      '{',
      '[null]',
      '{"a":',
    ])
      expect(experimentsIn(text)).toBeUndefined()
    const change = (experiments: unknown[]) => () => labOf(experiments)
    expect(change([{ scene: 'slope' }])).toThrow(/"slope" is not one of/)
    expect(change(Array(9).fill({ scene: 'ramp' }))).toThrow(/9 are not in 1…8/)
    expect(change([{ scene: 'ramp' }, { scene: 'fall' }])).toThrow(
      /runners\[1\]: is not like the first/,
    )
  })
})
