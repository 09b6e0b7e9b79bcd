/** What a game takes for the length of its frames, and what is drawn from it at the time when it is shown. */
import { describe, expect, it } from 'vitest'
import { FramesUntil } from '../../src/physics/framesUntil.ts'
import { parseExperiment, simulate } from '../../src/physics/index.ts'
import type { Experiment, FramesChoice, Timestep } from '../../src/physics/index.ts'
import { presentationErrors, trajectoryErrors } from '../../src/measure/index.ts'

const clocks: readonly FramesChoice[] = [
  { kind: 'steady', fps: 60 },
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 3 },
  { kind: 'hitch', fps: 60, every: 0.7, length: 0.25 },
  { kind: 'missed-vsync', fps: 60, seed: 5 },
  { kind: 'recorded', durations: [0.02, 0.011, 0.1, 0.0005] },
]

/** Every frame of a clock: when it ends, its length, and what the game measures [s]. */
function framesOf(frames: FramesChoice, duration = 3.01) {
  const each = new FramesUntil(parseExperiment({ scene: 'ramp', frames, duration }))
  const rows: { length: number; time: number; delta: number; measured: number }[] = []
  while (each.next()) {
    const { length, time, delta, measuredTime: measured } = each
    rows.push({ length, time, delta, measured })
  }
  return rows
}

/** Uniform motion, so that where a block is drawn tells by how much time the game has moved it. */
const gliding: Experiment = {
  scene: 'ramp',
  parameters: { angle: 0, muStatic: 0, muKinetic: 0, speed: 4 },
  duration: 3,
}

describe.each(clocks)('$kind frames', (clock) => {
  it('are what they are as long as nothing is said of the delta', () => {
    for (const { length, time, delta, measured } of framesOf(clock)) {
      expect(delta).toBe(length)
      expect(measured).toBe(time)
    }
    expect(simulate({ ...gliding, frames: { ...clock, delta: 'exact' } })).toEqual(
      simulate({ ...gliding, frames: clock }),
    )
  })

  it.each(['rounded', 'mean', 'snapped', 'late'] as const)(
    '%s deltas leave the frames themselves as they are, and add up',
    (delta) => {
      const rows = framesOf({ ...clock, delta })
      const truth = framesOf(clock)
      expect(rows.map(({ time }) => time)).toEqual(truth.map(({ time }) => time))
      let sum = 0
      for (const row of rows) expect(row.measured).toBeCloseTo((sum += row.delta), 10)
    },
  )

  it('rounded to whole milliseconds, stray by half a millisecond a frame at the most', () => {
    // The last frame is cut, and what was measured of it alike.
    const rows = framesOf({ ...clock, delta: 'rounded' })
    for (const [i, { length, time, delta, measured }] of rows.entries()) {
      if (i < rows.length - 1)
        expect(Math.abs(delta * 1000 - Math.round(delta * 1000))).toBeLessThan(1e-9)
      expect(Math.abs(delta - length)).toBeLessThanOrEqual(0.0005 + 1e-12)
      expect(Math.abs(measured - time)).toBeLessThanOrEqual(0.0005 * (i + 1) + 1e-9)
    }
  })

  it('as a mean of n, add up to the same but for n frames', () => {
    const meanOf = 7
    const rows = framesOf({ ...clock, delta: 'mean', meanOf })
    const whole = rows.slice(0, -1)
    whole.forEach(({ delta, time }, i) => {
      const from = i < meanOf ? 0 : rows[i - meanOf]!.time
      expect(delta).toBeCloseTo((time - from) / Math.min(i + 1, meanOf), 12)
    })
    // Once n frames have passed, the sum differs from the truth by what the first n and the last n frames are off.
    const longest = Math.max(...rows.map(({ length }) => length))
    for (const { measured, time } of rows)
      expect(Math.abs(measured - time)).toBeLessThan(meanOf * longest)
  })

  it('late by one frame, stand where the clock stood a frame ago', () => {
    const rows = framesOf({ ...clock, delta: 'late' })
    rows.slice(0, -1).forEach(({ measured }, i) => {
      expect(measured).toBeCloseTo(i === 0 ? 0 : rows[i - 1]!.time, 12)
    })
  })

  it('snapped, are whole refreshes, one at the least and the nearest', () => {
    for (const { delta, length } of framesOf({ ...clock, delta: 'snapped', snapTo: 75 }).slice(
      0,
      -1,
    )) {
      const refreshes = delta * 75
      expect(refreshes).toBeCloseTo(Math.max(1, Math.round(length * 75)), 9)
    }
  })
})

describe('what a player sees', () => {
  const drift = (frames: FramesChoice) =>
    presentationErrors(simulate({ ...gliding, frames })).atEnd / (4 * gliding.duration!)

  it('at a steady 60 fps in whole milliseconds, a game that runs 2 % fast', () => {
    expect(drift({ kind: 'steady', fps: 60, delta: 'rounded' })).toBeCloseTo(0.02, 12)
    expect(drift({ kind: 'steady', fps: 144, delta: 'rounded' })).toBeCloseTo(0.008, 12)
    expect(drift({ kind: 'steady', fps: 125, delta: 'rounded' })).toBeCloseTo(0, 12)
  })

  it('above 2000 fps in whole milliseconds, a game that stands still', () => {
    const run = simulate({ ...gliding, frames: { kind: 'steady', fps: 2500, delta: 'rounded' } })
    expect(run.drawnS[run.frames]).toBe(0)
    expect(run.time[run.frames]).toBe(3)
  })

  it('snapped to the wrong display, a game that is fast by the ratio of the two', () => {
    expect(drift({ kind: 'steady', fps: 75, delta: 'snapped' })).toBeCloseTo(0.25, 12)
    expect(drift({ kind: 'steady', fps: 59.94, delta: 'snapped' })).toBeCloseTo(-0.001, 12)
    expect(drift({ kind: 'steady', fps: 30, delta: 'snapped' })).toBeCloseTo(0, 12)
  })

  it('one frame late, the block where it was a frame ago', () => {
    const frames = { kind: 'missed-vsync', fps: 60, seed: 1 } as const
    const late = simulate({ ...gliding, frames: { ...frames, delta: 'late' } })
    for (let row = 2; row < late.frames; row++)
      expect(late.drawnS[row]).toBeCloseTo(4 * late.time[row - 1]!, 10)
  })

  it('with a mean, after a long frame, a block that is behind and catches up', () => {
    const durations = [...Array<number>(30).fill(0.01), 0.11, ...Array<number>(60).fill(0.01)]
    const frames = { kind: 'recorded', durations, delta: 'mean', meanOf: 10 } as const
    const { each } = presentationErrors(simulate({ ...gliding, duration: 1, frames }))
    expect(each[30]).toBeCloseTo(0, 12)
    // 100 ms too long a frame, of which a tenth is counted, and a tenth more in each of the next nine.
    expect(each[31]).toBeCloseTo(-4 * 0.09, 12)
    expect(each[35]).toBeCloseTo(-4 * 0.05, 12)
    expect(each[40]).toBeCloseTo(0, 12)
  })

  it('is not the error of the method, which is taken at the time that the game believes in', () => {
    const run = simulate({ ...gliding, frames: { kind: 'steady', fps: 60, delta: 'rounded' } })
    expect(trajectoryErrors(run).largest).toBeLessThan(1e-11)
    expect(run.stateTime[60]).toBeCloseTo(1.02, 12)
  })

  it('under fixed steps, every fiftieth frame of a steady 60 fps takes two', () => {
    const timestep = { kind: 'fixed', step: 1 / 60, draw: 'latest' } as const
    const stepsOf = (delta: 'exact' | 'rounded') => {
      const frames = { kind: 'steady', fps: 60, delta } as const
      const { stateTime } = simulate({ ...gliding, frames, timestep })
      return Array.from(stateTime.slice(1), (t, i) => Math.round((t - stateTime[i]!) * 60))
    }
    expect(new Set(stepsOf('exact'))).toEqual(new Set([1]))
    const doubled = stepsOf('rounded').flatMap((steps, i) => (steps === 2 ? [i + 1] : []))
    expect(doubled).toEqual([50, 100, 150])
  })
})

describe('slow motion', () => {
  const swing: Experiment = {
    scene: 'half-pipe',
    parameters: { position: 1.6, muStatic: 0.1, muKinetic: 0.1 },
    integrator: 'rk8',
    duration: 10,
  }
  const policies: readonly Timestep[] = [
    { kind: 'per-frame', step: 1 / 60 },
    { kind: 'variable' },
    { kind: 'capped', cap: 1 },
    { kind: 'substeps', step: 0.001 },
    { kind: 'fixed', step: 0.001, draw: 'latest' },
    { kind: 'tolerance', tolerance: 1e-10 },
  ]

  it.each(policies)('at 0.1× is the true motion of a tenth of the time, $kind', (timestep) => {
    const run = simulate({ ...swing, timestep, timeScale: 0.1 })
    expect(run.time[run.frames]).toBe(10)
    expect(run.gameTime[run.frames]).toBeCloseTo(1, 12)
    expect(run.stateTime[run.frames]).toBeCloseTo(1, 12)
    // Every one of the 600 frames, but for the fixed step that a frame may still wait for.
    const waits = timestep.kind === 'fixed' ? 0.001 * 6 : 0
    expect(presentationErrors(run).largest).toBeLessThan(1e-8 + waits)
    expect(trajectoryErrors(run).largest).toBeLessThan(1e-8)
  })

  it('is, frame by frame, a run with a tenth of the frames’ lengths', () => {
    const slow = simulate({ ...swing, timeScale: 0.1, frames: { kind: 'steady', fps: 60 } })
    const fast = simulate({ ...swing, duration: 1, frames: { kind: 'steady', fps: 600 } })
    slow.s.forEach((s, row) => {
      expect(s).toBeCloseTo(fast.s[row]!, 11)
    })
  })

  it('takes fewer fixed steps a second, and shorter ones without delta time', () => {
    const frames = { kind: 'steady', fps: 60 } as const
    const fixed = { ...swing, frames, timestep: { kind: 'fixed', step: 1 / 60 }, timeScale: 0.1 }
    expect(simulate(fixed as Experiment).steps).toBe(60)
    const perFrame = { ...fixed, timestep: { kind: 'per-frame', step: 1 / 60 } }
    expect(simulate(perFrame as Experiment).steps).toBe(600)
  })

  it('goes with a delta that is measured wrongly', () => {
    const frames = { kind: 'steady', fps: 60, delta: 'rounded' } as const
    const run = simulate({ ...gliding, frames, timeScale: 0.5 })
    expect(run.drawnS[run.frames]).toBeCloseTo(4 * 3 * 0.5 * 1.02, 10)
    expect(presentationErrors(run).atEnd).toBeCloseTo(4 * 3 * 0.5 * 0.02, 10)
  })
})
