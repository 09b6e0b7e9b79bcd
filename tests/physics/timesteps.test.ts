import { describe, expect, it } from 'vitest'
import { createRun, exactMotion, simulate, timesteps } from '../../src/physics/index.ts'
import type { Experiment, FramesChoice, Timestep, Trajectory } from '../../src/physics/index.ts'
import { MOST_STEPS_A_FRAME, wholeSteps } from '../../src/physics/timestepPolicy.ts'
import { last } from './truth.ts'

const sliding: Experiment = { scene: 'ramp', parameters: { speed: 1 }, duration: 5 }
const jittery: FramesChoice = { kind: 'jitter', fps: 60, amount: 0.9, seed: 4 }
const hitching: FramesChoice = { kind: 'hitch', fps: 60, every: 0.8, length: 0.5 }

const run = (timestep: Timestep, frames: FramesChoice = jittery): Trajectory =>
  simulate({ ...sliding, timestep, frames })

describe('timestep policies', () => {
  it('per-frame steps once a frame whatever the frame', () => {
    const result = run({ kind: 'per-frame', step: 0.01 })
    expect(result.steps).toBe(result.frames)
    for (let row = 0; row <= result.frames; row++) expect(result.stateTime[row]).toBe(row * 0.01)
  })

  it('variable steps once a frame, for as long', () => {
    const result = run({ kind: 'variable' })
    expect(result.steps).toBe(result.frames)
    expect(result.stateTime).toEqual(result.time)
    expect(result.lostTime).toBe(0)
  })

  it.each([jittery, hitching])(
    'capped reports the time that it loses, to rounding: %o',
    (frames) => {
      const cap = 0.02
      const result = run({ kind: 'capped', cap }, frames)
      let lost = 0
      for (let row = 1; row <= result.frames; row++)
        lost += Math.max(0, result.time[row]! - result.time[row - 1]! - cap)
      expect(lost).toBeGreaterThan(0.1)
      // The differences of rounded times are off by an ulp of 5 s each.
      expect(Math.abs(result.lostTime - lost)).toBeLessThan(result.frames * 1e-15)
      expect(last(result.stateTime)).toBeCloseTo(5 - result.lostTime, 13)
      // What is lost is lost: the block is where it was that much earlier.
      const { s } = exactMotion(sliding)(5 - result.lostTime, { s: 0, v: 0 })
      expect(last(result.s)).toBeCloseTo(s, 11)
    },
  )

  it('substeps cuts a frame into the fewest equal parts that are no longer than the step', () => {
    expect(run({ kind: 'substeps', step: 1 / 240 }, { kind: 'steady', fps: 60 }).steps).toBe(
      4 * 300,
    )
    expect(run({ kind: 'substeps', step: 1 / 250 }, { kind: 'steady', fps: 60 }).steps).toBe(
      5 * 300,
    )
    expect(run({ kind: 'substeps', step: 1 }, { kind: 'steady', fps: 60 }).steps).toBe(300)
    expect(run({ kind: 'substeps', step: 0.1 }, { kind: 'steady', fps: 1 }).steps).toBe(50)
  })

  it.each([jittery, hitching, { kind: 'steady', fps: 144 } as const])(
    'fixed takes every step that is due, none before: %o',
    (frames) => {
      const step = 1 / 50
      const result = run({ kind: 'fixed', step }, frames)
      for (let row = 0; row <= result.frames; row++) {
        const lag = result.time[row]! - result.stateTime[row]!
        expect(lag).toBeGreaterThanOrEqual(-1e-15)
        expect(lag).toBeLessThan(step + 1e-15)
      }
      expect(result.steps).toBe(250)
      expect(result.lostTime).toBe(0)
    },
  )

  it('fixed ends in the same bits whatever the frames', () => {
    const ends = [5, 30, 60, 144].map((fps) =>
      run({ kind: 'fixed', step: 1 / 60 }, { kind: 'steady', fps }),
    )
    for (const frames of [jittery, hitching])
      ends.push(run({ kind: 'fixed', step: 1 / 60 }, frames))
    for (const end of ends) {
      expect(last(end.s)).toBe(last(ends[0]!.s))
      expect(last(end.v)).toBe(last(ends[0]!.v))
    }
  })

  it('fixed drops what exceeds its bound, in whole steps, and says how much', () => {
    const step = 1 / 60
    const result = run(
      { kind: 'fixed', step, maxSteps: 4 },
      { kind: 'hitch', fps: 60, every: 1, length: 0.5 },
    )
    let due = 0
    for (let row = 1; row <= result.frames; row++)
      due += Math.max(
        0,
        wholeSteps(result.time[row]!, step) - wholeSteps(result.time[row - 1]!, step) - 4,
      )
    expect(due).toBeGreaterThan(50)
    expect(result.lostTime).toBe(due * step)
    expect(result.steps).toBe(300 - due)
    expect(last(result.stateTime)).toBeCloseTo(5 - result.lostTime, 13)
  })

  it('the spiral of death is bounded: steps of 1 ms, frames of 2 s', () => {
    const death: Experiment = {
      ...sliding,
      timestep: { kind: 'fixed', step: 1 / 1000, maxSteps: 50 },
      frames: { kind: 'recorded', durations: [2] },
      duration: 20,
    }
    const result = simulate(death)
    expect(result.frames).toBe(10)
    expect(result.steps).toBe(500)
    expect(result.lostTime).toBeCloseTo(19.5, 12)
  })

  it.each([{ kind: 'fixed', step: 1e-3 } as const, { kind: 'substeps', step: 1e-3 } as const])(
    'a frame longer than everything else neither hangs nor loses time silently: %o',
    (timestep) => {
      const game = createRun({ ...sliding, timestep })
      game.frame(1 / 60)
      game.frame(1e7)
      expect(game.steps).toBeLessThanOrEqual(MOST_STEPS_A_FRAME + 17)
      // All but 100 000 steps of 1 ms; of 1e7 s an ulp is 2e-9 s.
      expect(Math.abs(game.lostTime - (1e7 - 100))).toBeLessThan(1e-3)
      expect(Math.abs(game.time - game.stateTime - game.lostTime)).toBeLessThan(1.1e-3)
      game.frame(1 / 60)
      expect(game.steps).toBeLessThanOrEqual(MOST_STEPS_A_FRAME + 35)
    },
  )

  it('substeps takes a remainder of eight ulps of the frame for rounding, and no larger one', () => {
    const steps = (step: number, fps: number) =>
      simulate({
        ...sliding,
        timestep: { kind: 'substeps', step },
        frames: { kind: 'steady', fps },
        duration: 1 / fps,
      }).steps
    const ulp = Number.EPSILON
    expect(steps(1 - 8 * ulp, 1)).toBe(1)
    expect(steps(1 - 9 * ulp, 1)).toBe(2)
    // The bound goes with the frame.
    expect(steps(0.001 * (1 - 1e-13), 1000)).toBe(2)
  })

  it.each([
    { kind: 'variable' },
    { kind: 'capped', cap: 0.05 },
    { kind: 'substeps', step: 1e-3 },
  ] as const)('a frame of no length is one step of none: %o', (timestep) => {
    const game = createRun({ ...sliding, timestep })
    game.frame(1 / 60)
    const { steps } = game
    const { s, v } = game.motion
    game.frame(0)
    expect(game.steps).toBe(steps + 1)
    expect([game.motion.s, game.motion.v, game.stateTime]).toEqual([s, v, 1 / 60])
  })

  it('counts whole steps in spite of rounding', () => {
    const numbers = Array.from({ length: 3000 }, (_, i) => i + 1)
    for (const fps of [24, 30, 60, 144, 240])
      expect(numbers.filter((i) => wholeSteps(i / fps, 1 / fps) !== i)).toEqual([])
    expect(wholeSteps(0.999, 1 / 60)).toBe(59)
  })

  it('are all tested here', () => {
    expect(timesteps.map(({ id }) => id)).toEqual([
      'per-frame',
      'variable',
      'capped',
      'substeps',
      'fixed',
      'tolerance',
    ])
  })
})

describe('drawing under fixed', () => {
  const step = 1 / 20
  const drawn = (draw: 'latest' | 'interpolated' | 'extrapolated') =>
    run({ kind: 'fixed', step, draw }, { kind: 'steady', fps: 144 })
  const truth = exactMotion(sliding)
  const at = (t: number) => truth(t, { s: 0, v: 0 })

  it('latest shows the last state', () => {
    const result = drawn('latest')
    expect(result.drawnS).toEqual(result.s)
  })

  it('interpolated lies on the line between the two states that bracket the instant a step ago', () => {
    const { drawnS, time, frames } = drawn('interpolated')
    for (let row = 1; row <= frames; row++) {
      const instant = time[row]! - step
      if (instant < 0) continue
      const before = Math.floor(instant / step + 1e-9) * step
      const weight = (instant - before) / step
      // The states are exact here, so the line between them is known.
      const line = (1 - weight) * at(before).s + weight * at(before + step).s
      expect(drawnS[row]!).toBeCloseTo(line, 11)
    }
  })

  it.each(['interpolated', 'extrapolated'] as const)(
    '%s after steps were dropped goes by what is left of the frame',
    (draw) => {
      const game = createRun({ ...sliding, timestep: { kind: 'fixed', step, maxSteps: 2, draw } })
      for (const duration of [0.12, 0.5, 0.03, 0.04]) {
        game.frame(duration)
        const { s, v } = game.motion
        const left = game.time - game.stateTime - game.lostTime
        expect(left).toBeGreaterThan(-1e-12)
        expect(left).toBeLessThan(step)
        const before = at(game.stateTime - step).s
        const line = draw === 'extrapolated' ? s + v * left : before + (s - before) * (left / step)
        expect(game.drawnS).toBeCloseTo(line, 12)
      }
      // Of 0.69 s there are 13 steps; the second frame had 10 due and took 2.
      expect(game.lostTime).toBeCloseTo(8 * step, 12)
    },
  )

  it('extrapolated goes on from the last state at its speed', () => {
    const { drawnS, time, s, v, stateTime, frames } = drawn('extrapolated')
    for (let row = 0; row <= frames; row++)
      expect(drawnS[row]!).toBeCloseTo(s[row]! + v[row]! * (time[row]! - stateTime[row]!), 12)
  })
})
