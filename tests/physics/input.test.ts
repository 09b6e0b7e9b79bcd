/** Presses that fixed ticks lose or count twice, and the way to keep them. */
import { describe, expect, it } from 'vitest'
import { readPresses } from '../../src/physics/input.ts'
import { Random } from '../../src/physics/random.ts'

const steady = (fps: number, duration: number) =>
  Array.from({ length: Math.ceil(fps * duration) }, (_, i) => (i + 1) / fps)

describe('by hand', () => {
  // Frames of 60, 100 and 40 ms, with ticks of 50 ms: one, two and one of them.
  const ends = [0.06, 0.16, 0.2]

  it('a press in a frame with two ticks counts in both, and is kept for one', () => {
    expect(readPresses(ends, 0.05, [0.1])).toEqual([
      { time: 0.1, frame: 1, counted: [2, 3], kept: 2, keptIn: 1 },
    ])
  })

  it('a press in a frame without a tick is lost, and is kept for the next frame’s', () => {
    expect(readPresses([0.06, 0.09, 0.12], 0.05, [0.07])).toEqual([
      { time: 0.07, frame: 1, counted: [], kept: 2, keptIn: 2 },
    ])
  })

  it('a press at the very end of a frame belongs to it, one after the last to none', () => {
    const [first, last] = readPresses(ends, 0.05, [0.3, 0.06])
    expect(first).toMatchObject({ time: 0.06, frame: 0, counted: [1], kept: 1 })
    expect(last).toMatchObject({ time: 0.3, frame: -1, counted: [], kept: 0, keptIn: -1 })
  })

  it('of two presses in one frame, each has a tick of its own', () => {
    const kept = readPresses(ends, 0.05, [0.01, 0.02, 0.03]).map(({ kept }) => kept)
    expect(kept).toEqual([1, 2, 3])
  })
})

describe('at steady frames', () => {
  const step = 1 / 50
  const presses = Array.from({ length: 6000 }, (_, i) => (i + 0.5) / 6000)
  const part = (fps: number, ticks: number) =>
    readPresses(steady(fps, 1.5), step, presses).filter(({ counted }) => counted.length === ticks)
      .length / presses.length

  it('faster than the ticks, the part of the frames that have none is lost', () => {
    // 50 of fps frames have a tick.
    for (const fps of [60, 75, 100, 120, 240]) {
      expect(part(fps, 0)).toBeCloseTo(1 - 50 / fps, 9)
      expect(part(fps, 1)).toBeCloseTo(50 / fps, 9)
    }
  })

  it('slower than the ticks, the part of the frames that have two counts twice', () => {
    for (const fps of [25, 30, 40]) {
      expect(part(fps, 0)).toBe(0)
      expect(part(fps, 2)).toBeCloseTo(50 / fps - 1, 9)
    }
  })

  it('of the same rate, every press counts once', () => {
    expect(part(50, 1)).toBe(1)
  })
})

describe('whatever the frames', () => {
  const random = new Random(7)
  const uniform = () => random.next() / 2 ** 32
  const step = 0.02
  const runs = Array.from({ length: 50 }, () => {
    const lengths = Array.from({ length: 60 }, () => 0.001 + 0.05 * uniform() ** 2)
    let end = 0
    const ends = lengths.map((length) => (end += length))
    // Not so close that they have to queue, and none so late that no tick is left for it.
    const times: number[] = []
    for (let t = 0.1 * uniform(); t < end - 0.2; t += 0.08 + 0.1 * uniform()) times.push(t)
    return { ends, longest: Math.max(...lengths), times, presses: readPresses(ends, step, times) }
  })

  it('a kept press counts once, in a tick of its own, in the order in which they came', () => {
    for (const { times, presses } of runs) {
      const ticks = presses.map(({ kept }) => kept)
      expect(presses.map(({ time }) => time)).toEqual(times)
      expect(ticks.every((tick, i) => tick > (ticks[i - 1] ?? 0))).toBe(true)
    }
  })

  it('it waits for a frame and a tick at the most, and for the frame of that tick to end', () => {
    for (const { ends, longest, presses } of runs)
      for (const { time, keptIn } of presses) {
        expect(ends[keptIn]! - time).toBeGreaterThanOrEqual(0)
        expect(ends[keptIn]! - time).toBeLessThanOrEqual(2 * longest + step)
      }
  })

  it('the first tick that a press counts in, if there is one, is that which keeps it', () => {
    const all = runs.flatMap(({ presses }) => presses)
    const counts = new Set(all.map(({ counted }) => Math.min(2, counted.length)))
    expect(counts).toEqual(new Set([0, 1, 2]))
    for (const { counted, kept, frame, keptIn } of all) {
      if (counted.length > 0) expect([counted[0], frame]).toEqual([kept, keptIn])
      else expect(keptIn).toBeGreaterThan(frame)
    }
  })
})
