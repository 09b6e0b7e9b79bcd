import { describe, expect, it } from 'vitest'
import { frameClocks } from '../../src/physics/index.ts'
import type { FramesChoice } from '../../src/physics/index.ts'
import type { Frames } from '../../src/physics/frameClock.ts'
import { clockOf } from '../../src/physics/frames/index.ts'
import { samples } from '../samples.ts'

function start(choice: FramesChoice): Frames {
  return clockOf(choice).start()
}

function ulp(x: number): number {
  return 2 ** (Math.floor(Math.log2(x)) - 52)
}

const choices: FramesChoice[] = [
  { kind: 'steady', fps: 60 },
  { kind: 'steady', fps: 144 },
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 3 },
  { kind: 'hitch', fps: 60, every: 1, length: 0.5 },
  // Hitches longer than their interval: 0.2 s are left to the next that is due.
  { kind: 'hitch', fps: 100, every: 0.3, length: 0.4 },
  // One frame fits between two hitches, to the bit.
  { kind: 'hitch', fps: 4, every: 1, length: 0.75 },
  { kind: 'missed-vsync', fps: 144, seed: 3 },
  { kind: 'recorded', durations: [0.016, 0.017, 0.0331, 1 / 7] },
]

describe('frame clocks', () => {
  it('are all tested here', () => {
    expect(new Set(choices.map(({ kind }) => kind))).toEqual(
      new Set(frameClocks.map(({ id }) => id)),
    )
  })

  it.each([60, 144])(
    'the time of steady frames at 1/%i s is rounded once, however many there are',
    (fps) => {
      const frames = start({ kind: 'steady', fps })
      const count = samples(500_000, 10_000_000)
      for (let i = 0; i < count; i++) frames.next()
      expect(frames.time).toBe(count / fps)
    },
  )

  it.each(choices)('many frames do not drift: %o', (choice) => {
    const frames = start(choice)
    // The sum of all durations as whole numbers of 2⁻⁸⁰ s, which is exact.
    let exact = 0n
    const count = samples(500_000, 10_000_000)
    const seen = new Map<number, number>()
    for (let i = 0; i < count; i++) {
      frames.next()
      // Jittered durations are all different: their clock counts the stray in whole numbers, checked on its own below.
      if (choice.kind !== 'jitter') seen.set(frames.duration, (seen.get(frames.duration) ?? 0) + 1)
    }
    for (const [duration, times] of seen) exact += BigInt(duration * 2 ** 80) * BigInt(times)
    // Each duration is itself a rounded number, by half an ulp of its own: half an ulp of the sum at the most.
    if (choice.kind !== 'jitter')
      expect(Math.abs(frames.time - Number(exact) / 2 ** 80)).toBeLessThanOrEqual(ulp(frames.time))
  })

  it('jitter: its time is the sum of its frames, evenly spread within (1 ± amount)/fps', () => {
    const frames = start({ kind: 'jitter', fps: 50, amount: 0.8, seed: 11 })
    let exact = 0n
    let smallest = Infinity
    let largest = 0
    const count = 200_000
    for (let i = 0; i < count; i++) {
      frames.next()
      exact += BigInt(Math.round(frames.duration * 2 ** 62)) << 18n
      smallest = Math.min(smallest, frames.duration)
      largest = Math.max(largest, frames.duration)
    }
    // Roundings of the single durations add up like a walk: their number's square root, in units of 2⁻⁵⁸ s.
    expect(Math.abs(frames.time - Number(exact) / 2 ** 80)).toBeLessThan(
      6 * Math.sqrt(count) * 2 ** -58 + ulp(frames.time),
    )
    expect(smallest).toBeGreaterThanOrEqual(0.2 / 50)
    expect(smallest).toBeLessThan(0.201 / 50)
    expect(largest).toBeLessThanOrEqual(1.8 / 50)
    expect(largest).toBeGreaterThan(1.799 / 50)
    // The mean of n even draws scatters by amount/√(3n).
    expect(Math.abs(frames.time / count - 1 / 50)).toBeLessThan(
      (6 * 0.8) / 50 / Math.sqrt(3 * count),
    )
  })

  it('hitch: one long frame for every interval, the rest steady', () => {
    const frames = start({ kind: 'hitch', fps: 10, every: 1, length: 0.5 })
    const durations: number[] = []
    for (let i = 0; i < 22; i++) {
      frames.next()
      durations.push(frames.duration)
    }
    expect(frames.time).toBe(3)
    const long = durations.flatMap((duration, i) => (duration === 0.5 ? [i] : []))
    // Ten frames to 1 s, a hitch to 1.5 s, five frames to 2 s, a hitch.
    expect(long).toEqual([10, 16])
    expect(
      durations.filter((duration) => duration !== 0.5).every((duration) => duration === 0.1),
    ).toBe(true)
  })

  it('hitch: one longer than its interval does not swallow everything', () => {
    const frames = start({ kind: 'hitch', fps: 10, every: 0.3, length: 0.4 })
    const kinds = new Set<number>()
    for (let i = 0; i < 20; i++) {
      frames.next()
      kinds.add(frames.duration)
    }
    expect(kinds).toEqual(new Set([0.1, 0.4]))
  })

  describe('missed vsync', () => {
    const fps = 60
    const count = samples(200_000)
    /** How many refreshes each frame takes. */
    const refreshes = (seed: number) => {
      const frames = start({ kind: 'missed-vsync', fps, seed })
      return Array.from({ length: count }, () => (frames.next(), Math.round(frames.duration * fps)))
    }
    const seeds = [0, 1, 5, 2654435769, 4294967295]
    const share = (all: readonly number[], of: number) =>
      all.filter((each) => each === of).length / all.length

    // A chain that stays as it is with 1 − 1/32 − 1/4 makes the mean of n frames scatter as that of n(1 − λ)/(1 + λ) = n/6
    // single ones would; six standard deviations of a share p are 6 √(6 p (1 − p)/n).
    const give = (p: number) => 6 * Math.sqrt((6 * p * (1 - p)) / count)

    it.each(seeds)(
      'seed %i: one refresh mostly, two in 1/18 of the frames, three in 1/36',
      (seed) => {
        const all = refreshes(seed)
        expect(Math.abs(share(all, 1) - 11 / 12)).toBeLessThan(give(1 / 12))
        expect(Math.abs(share(all, 2) - 1 / 18)).toBeLessThan(give(1 / 18))
        expect(Math.abs(share(all, 3) - 1 / 36)).toBeLessThan(give(1 / 36))
        expect(new Set(all)).toEqual(new Set([1, 2, 3]))
      },
    )

    it.each(seeds)('seed %i: 60 Hz are 54 frames a second', (seed) => {
      const mean = refreshes(seed).reduce((sum, each) => sum + each, 0) / count
      // A frame's refreshes have a variance of 1/6.
      expect(Math.abs(fps / mean - 54)).toBeLessThan((54 * 6) / Math.sqrt(count))
    })

    it.each(seeds)('seed %i: a long frame follows a long one in 9/16 of all cases', (seed) => {
      const all = refreshes(seed)
      const after = all.filter((_, i) => i > 0 && all[i - 1]! > 1)
      const long = 1 - share(after, 1)
      // The game stays busy with 3/4 and is late then with 3/4; without bursts it would be 1/12.
      expect(Math.abs(long - 9 / 16)).toBeLessThan(6 * Math.sqrt((9 / 16 / 16) * 7 * (12 / count)))
    })
  })

  it.each([1, 2, 3].flatMap((shift) => [0, 1, 77, 4e9].map((seed) => ({ seed, shift }))))(
    'a seed $shift Weyl steps from $seed gives another sequence, not the same one shifted',
    ({ seed, shift }) => {
      const draws = (from: number) => {
        const frames = start({ kind: 'jitter', fps: 60, amount: 0.5, seed: from >>> 0 })
        return Array.from({ length: 1000 }, () => (frames.next(), frames.duration))
      }
      const first = new Set(draws(seed))
      const common = draws(seed + shift * 0x9e3779b9).filter((each) => first.has(each))
      // Of a million pairs of 2³² values, none or one agrees by chance.
      expect(common.length).toBeLessThan(3)
    },
  )

  it('recorded: from the start again when it runs out', () => {
    const frames = start({ kind: 'recorded', durations: [0.25, 0.5] })
    const times = Array.from({ length: 4 }, () => (frames.next(), frames.time))
    expect(times).toEqual([0.25, 0.75, 1, 1.5])
  })

  it.each(choices)('tell how many frames a run has: %o', (choice) => {
    const frames = start(choice)
    const count = samples(100_000)
    for (let i = 0; i < count; i++) frames.next()
    // Chance leaves at most six standard deviations of the mean, below 1 % of so many.
    const give = 0.01 * Math.sqrt(100_000 / count)
    expect(Math.abs(clockOf(choice).frames(frames.time) / count - 1)).toBeLessThan(give)
  })

  it.each<FramesChoice>([
    // A run that is over before the first hitch, and one whose every interval is filled by its hitch.
    { kind: 'hitch', fps: 1000, every: 60, length: 60 },
    { kind: 'hitch', fps: 1000, every: 0.5, length: 60 },
    // Hitches that end just before the next is due, or just after, and hitches shorter than a frame.
    { kind: 'hitch', fps: 50, every: 1, length: 1.9999883 },
    { kind: 'hitch', fps: 50, every: 1, length: 2.0000001 },
    { kind: 'hitch', fps: 1, every: 0.01, length: 0.25 },
    { kind: 'hitch', fps: 1, every: 0.25, length: 0.25 },
    { kind: 'hitch', fps: 5.5, every: 0.01, length: 3.95 },
    { kind: 'hitch', fps: 60, every: 0.0145, length: 0.001 },
    { kind: 'recorded', durations: [0.001, 0.001, 0.001, 60] },
  ])('tell how many frames a run has that ends among the short ones: %o', (choice) => {
    const frames = start(choice)
    for (let count = 0; count < 2000; count++) {
      // The frame that reaches the end counts, and the steps to it may be rounded up.
      expect(count).toBeLessThanOrEqual(clockOf(choice).frames(frames.time) * (1 + 1e-12))
      frames.next()
    }
  })

  it.each<FramesChoice>([
    { kind: 'hitch', fps: 60, every: 0.0145, length: 0.001 },
    { kind: 'hitch', fps: 50, every: 1, length: 0.9999 },
  ])('tell of not twice as many frames as there are: %o', (choice) => {
    const frames = start(choice)
    for (let i = 0; i < 2000; i++) frames.next()
    expect(clockOf(choice).frames(frames.time)).toBeLessThan(4000)
  })

  it('draw the same frames for the same seed, and others for another', () => {
    const durations = (seed: number) => {
      const frames = start({ kind: 'jitter', fps: 60, amount: 0.5, seed })
      return Array.from({ length: 10 }, () => (frames.next(), frames.duration))
    }
    expect(durations(1)).toEqual(durations(1))
    expect(durations(1)).not.toEqual(durations(2))
  })
})
