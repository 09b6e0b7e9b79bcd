import { describe, expect, it } from 'vitest'
import { exact, simulate } from '../../src/physics/index.ts'
import type { Experiment, FramesChoice } from '../../src/physics/index.ts'
import { last, relative } from './truth.ts'

const clocks: FramesChoice[] = [
  { kind: 'steady', fps: 5 },
  { kind: 'steady', fps: 60 },
  { kind: 'steady', fps: 144 },
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 7 },
  { kind: 'hitch', fps: 60, every: 0.6, length: 0.5 },
  { kind: 'recorded', durations: [0.011, 0.017, 0.13, 0.009] },
]

// Verlet is exact to rounding on both, so that time left out shows: at 20 m/s even 1e-9 of a frame of 1/144 s is 1.4e-10 m.
const motions: Experiment[] = [
  { scene: 'ramp', parameters: { speed: 20, muStatic: 0, muKinetic: 0 } },
  { scene: 'fall', parameters: { speed: 20 } },
]

/** No frame of the clock is shorter [s]. */
function shortestFrame(frames: FramesChoice): number {
  if (frames.kind === 'recorded') return Math.min(...frames.durations)
  return (frames.kind === 'jitter' ? 1 - frames.amount : 1) / frames.fps
}

/** When the 37th frame of a clock ends [s]. */
function wholeFrames(frames: FramesChoice): number {
  return simulate({ ...motions[0]!, frames, duration: 20 }).time[37]!
}

describe.each(clocks)('at $kind frames, $fps fps', (frames) => {
  const whole = wholeFrames(frames)
  const frame = shortestFrame(frames)

  it.each([1e-9, 3e-10, 1e-8, 1e-6, 1e-3, 0.5])(
    'a duration of %s of a frame more than whole frames ends exactly there',
    (part) => {
      for (const motion of motions) {
        const duration = whole + part * frame
        const run = simulate({ ...motion, frames, duration })
        expect(run.frames).toBe(38)
        expect(last(run.time)).toBe(duration)
        expect(last(run.stateTime)).toBe(duration)
        const { s } = exact(motion, duration)
        // Thirty-eight steps, of an ulp each: far less than what the part of a frame is worth.
        expect(relative(last(run.s) - s, s)).toBeLessThanOrEqual(20 * Number.EPSILON)
      }
    },
  )

  it.each([1e-9, 1e-6, 1e-3])(
    'a duration of %s of a frame less than whole frames ends exactly there',
    (part) => {
      for (const motion of motions) {
        const duration = whole - part * frame
        const run = simulate({ ...motion, frames, duration })
        expect(run.frames).toBe(37)
        expect(last(run.time)).toBe(duration)
        const { s } = exact(motion, duration)
        expect(relative(last(run.s) - s, s)).toBeLessThanOrEqual(20 * Number.EPSILON)
      }
    },
  )

  it('a duration of whole frames has no frame more', () => {
    const run = simulate({ ...motions[0]!, frames, duration: whole })
    expect(run.frames).toBe(37)
    expect(last(run.time)).toBe(whole)
  })
})

it('a duration written as so many times a frame’s length has no frame of rounding at its end', () => {
  for (const fps of [24, 30, 59.94, 60, 90, 144, 240])
    for (const count of [1, 7, 100, 719]) {
      const run = simulate({
        ...{ scene: 'ramp', frames: { kind: 'steady', fps } },
        duration: count * (1 / fps),
      })
      expect(run.frames, `${count} at ${fps} fps`).toBe(count)
    }
})
