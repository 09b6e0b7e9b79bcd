import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { isReadable, readAddress, whyNoLink, writeAddress } from '../../../src/lab/state/address.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { binsOf } from '../../../src/panels/record/histogram.ts'
import { readDurations, writeDurations, writeRounded } from '../../../src/lab/state/durationCode.ts'
import { durationsOf, summarize } from '../../../src/lab/state/frameTimes.ts'
import { record } from '../../../src/panels/record/recording.ts'
import { changed } from '../../../src/lab/state/change.ts'

/** Five seconds of a 60 Hz display that misses every hundredth refresh, as timestamps [ms]. */
const refreshes = Array.from({ length: 300 }, (_, i) => i).filter((i) => i % 100 !== 50)
const timestamps = refreshes.map((i) => 12345.6 + (i * 1000) / 60)

describe('frame times', () => {
  test('are whole tenths of a millisecond that add up to what passed', () => {
    const durations = durationsOf(timestamps)
    expect(durations).toHaveLength(296)
    for (const each of durations) expect([0.0166, 0.0167, 0.0333, 0.0334]).toContain(each)
    const total = durations.reduce((sum, each) => sum + each, 0)
    expect(total).toBeCloseTo((timestamps.at(-1)! - timestamps[0]!) / 1000, 4)
  })

  test('are at least one tick and at most what the clock takes, and fit in a link', () => {
    expect(durationsOf([0, 0, 0.01, 16, 16, 90_000])).toEqual([0.016, 60])
    expect(durationsOf([])).toEqual([])
    expect(durationsOf([5])).toEqual([])
    expect(durationsOf(Array.from({ length: 4000 }, (_, i) => i))).toHaveLength(1500)
  })

  test('are summed up', () => {
    const { frames, median, most, longest, rate } = summarize(durationsOf(timestamps))
    expect({ frames, median, most, longest }).toEqual({
      ...{ frames: 296, median: 0.0167, most: 0.0333, longest: 0.0334 },
    })
    expect(rate).toBeCloseTo(60, 1)
    // A browser that rounds to whole milliseconds shows 16 and 17 ms.
    expect(summarize([0.017, 0.017, 0.016, 0.017, 0.017, 0.016]).rate).toBeCloseTo(60, 0)
    expect(summarize([0.02])).toEqual({
      ...{ frames: 1, total: 0.02, median: 0.02, most: 0.02, longest: 0.02, rate: 50 },
    })
  })

  test('fall into bins of a round width, each into one', () => {
    const durations = durationsOf(timestamps)
    const bins = binsOf(durations, 0.0167)
    expect(bins[1]!.from).toBe(0.001)
    expect(bins.map(({ count }) => count).reduce((a, b) => a + b)).toBe(durations.length)
    expect(bins[16]).toEqual({ from: 0.016, to: 0.017, count: 293 })
    expect(bins[33]).toEqual({ from: 0.033, to: 0.034, count: 3 })
    // On an edge: the bin that begins there.
    expect(binsOf([0.016], 0.016)[16]!.count).toBe(1)
    // Far beyond: the last one, which says so.
    const withLong = binsOf([0.016, 5], 0.016)
    expect(withLong).toHaveLength(40)
    expect(withLong.at(-1)).toEqual({ from: 0.039, to: Infinity, count: 1 })
  })
})

describe('frame times as text', () => {
  const ticks = fc.array(
    fc.oneof(fc.integer({ min: 160, max: 172 }), fc.integer({ min: 1, max: 600_000 })),
    {
      minLength: 1,
      maxLength: 200,
    },
  )

  test('come back as they were', () => {
    fc.assert(
      fc.property(ticks, (list) => {
        const durations = list.map((tick) => tick / 10_000)
        const text = writeDurations(durations)!
        expect(readDurations(text)).toEqual(durations)
        expect(encodeURIComponent(text)).toBe(text)
      }),
    )
  })

  test('are short: about a letter a frame, and less where nothing changes', () => {
    expect(writeDurations(new Array<number>(300).fill(0.0167))).toBe('4n-m300')
    expect(writeDurations([0.0167, 0.0167, 0.0167, 0.0166, 0.0167, 0.0333])).toBe('4n-m3lm_99')
    expect(writeDurations(durationsOf(timestamps))!.length).toBeLessThan(310)
  })

  test('come back as they were where they are whole microseconds', () => {
    const list = fc.array(
      fc.oneof(fc.integer({ min: 16_000, max: 17_300 }), fc.integer({ min: 10, max: 60_000_000 })),
      { minLength: 1, maxLength: 200 },
    )
    fc.assert(
      fc.property(list, (microseconds) => {
        const durations = microseconds.map((each) => each / 1e6)
        const text = writeDurations(durations)!
        expect(readDurations(text)).toEqual(durations)
        expect(encodeURIComponent(text)).toBe(text)
        expect(readDurations(writeRounded(durations))).toEqual(durations)
      }),
    )
    expect(writeDurations([0.016671, 0.016671, 0.01669])).toBe('~-xgBAAmB')
  })

  test('are rounded so that they add up to what passed', () => {
    const exact = Array.from({ length: 6000 }, () => 1 / 60)
    const rounded = readDurations(writeRounded(exact))!
    for (const each of rounded) expect([0.016666, 0.016667]).toContain(each)
    expect(rounded.reduce((sum, each) => sum + each, 0)).toBeCloseTo(100, 6)
    // As short as the clock allows, and no shorter.
    expect(readDurations(writeRounded([1e-5, 1e-5]))).toEqual([1e-5, 1e-5])
  })

  test('take three characters a frame or fewer where they vary by half a millisecond', () => {
    const durations = Array.from(
      { length: 10_000 },
      (_, i) => (16_667 + ((i * 7919) % 1021) - 510) / 1e6,
    )
    expect(writeDurations(durations)!.length).toBeLessThan(2 * 10_000 + 10)
  })

  test('are none where they are not whole microseconds', () => {
    for (const durations of [[1 / 60], [0.0167101], [0], [-0.1], [NaN], [Infinity], []])
      expect(writeDurations(durations)).toBeUndefined()
    for (const text of [
      '0.016+0.033',
      '0.02',
      '1e-5',
      '',
      '4n',
      '4n-',
      '4n-M3',
      '-m',
      '4n-3',
      '~',
      '~A',
      '~-hg',
      '~A B',
      '~Ah',
    ])
      expect(readDurations(text)).toBeUndefined()
  })

  test('that ask for far too many are cut, and refused', () => {
    expect(readDurations('4n-m999999999m999999999')).toHaveLength(200_000)
    expect(() => readAddress('runners=recorded(durations:4n-m999999999)')).toThrow(/durations/)
    expect(() => readAddress('runners=recorded(durations:1-a)')).toThrow(/durations/)
  })

  test('stand in the address', () => {
    const frames = { kind: 'recorded' as const, durations: durationsOf(timestamps) }
    const state = changed(opening, { kind: 'add', frames })
    const address = writeAddress(state)
    expect(address.length).toBeLessThan(500)
    expect(readAddress(address)).toEqual(state)
    const short = changed(opening, {
      kind: 'runner',
      index: 0,
      values: { frames: { kind: 'recorded', durations: [1 / 60, 0.02] } },
    })
    expect(readAddress(writeAddress(short))).toEqual(short)
  })
})

describe('a long list in an address', () => {
  const recorded = (durations: readonly number[]) =>
    changed(opening, { kind: 'add', frames: { kind: 'recorded', durations } })
  /** As a game that draws at 144 Hz or so, in whole microseconds. */
  const log = (length: number) =>
    Array.from({ length }, (_, i) => (6944 + ((i * 7919) % 1009) - 504) / 1e6)

  test('comes back as it was while the address can be read, and there is no link beyond that', () => {
    for (const length of [101, 20_000]) {
      const state = recorded(log(length))
      expect(whyNoLink(state)).toBe('')
      expect(readAddress(writeAddress(state))).toEqual(state)
    }
    const state = recorded(log(100_000))
    expect(isReadable(writeAddress(state))).toBe(false)
    expect(whyNoLink(state)).toMatch(
      /^Too many recorded frames for a link: it would have \d{3}.\d{3} /,
    )
    expect(() => readAddress(writeAddress(state))).toThrow(/more than the 50000 that are read/)
  })

  test('of times that are no whole microseconds is rounded, and then stays as it is', () => {
    const state = recorded(Array.from({ length: 5000 }, () => 1 / 60))
    const back = readAddress(writeAddress(state))
    expect(readAddress(writeAddress(back))).toEqual(back)
    const { frames } = back.runners.at(-1)!
    if (frames.kind !== 'recorded') return expect.unreachable()
    for (const each of frames.durations) expect(Math.abs(each - 1 / 60)).toBeLessThan(1e-6)
  })
})

describe('a recording', () => {
  /** Frames that begin when the test says so. */
  function manual() {
    let waiting: ((timestamp: number) => void) | undefined
    return {
      source: (callback: (timestamp: number) => void) => {
        waiting = callback
        return () => (waiting = undefined)
      },
      frame: (timestamp: number) => {
        const callback = waiting
        waiting = undefined
        callback?.(timestamp)
      },
      get waits() {
        return waiting !== undefined
      },
    }
  }

  test('takes down the frames of its length, tells how far it is, and asks for no more', () => {
    const frames = manual()
    const parts: number[] = []
    const results: number[][] = []
    record({
      ...{ source: frames.source, length: 0.1 },
      progress: (part) => parts.push(part),
      done: (timestamps) => results.push(timestamps),
    })
    for (const timestamp of [1000, 1040, 1080]) frames.frame(timestamp)
    expect(results).toEqual([])
    expect(frames.waits).toBe(true)
    for (const timestamp of [1110, 1150]) frames.frame(timestamp)
    expect(results).toEqual([[1000, 1040, 1080, 1110]])
    expect(parts.map((part) => part.toFixed(1))).toEqual(['0.0', '0.4', '0.8'])
    expect(frames.waits).toBe(false)
  })

  test('that is called off asks for no more and is never done', () => {
    const frames = manual()
    const fail = () => expect.unreachable()
    const cancel = record({ source: frames.source, length: 0.1, progress: () => {}, done: fail })
    frames.frame(0)
    cancel()
    expect(frames.waits).toBe(false)
    frames.frame(200)
  })
})
