/** A run driven by its clock: which frames it has, how the last is cut, and when what happens has happened. */
import { describe, expect, it } from 'vitest'
import { createRun, frameClocks, simulate, timesteps } from '../../src/physics/index.ts'
import type { Experiment, FramesChoice, Timestep } from '../../src/physics/index.ts'
import { clockOf } from '../../src/physics/frames/index.ts'
import { last } from './truth.ts'

const clocks: FramesChoice[] = [
  { kind: 'steady', fps: 240 },
  { kind: 'jitter', fps: 240, amount: 0.9, seed: 5 },
  { kind: 'hitch', fps: 240, every: 0.5, length: 0.3 },
  { kind: 'missed-vsync', fps: 240, seed: 5 },
  { kind: 'recorded', durations: [0.002, 0.005, 0.0011] },
]

describe('the frames of a run', () => {
  it('are tested with every clock', () => {
    expect(clocks.map(({ kind }) => kind)).toEqual(frameClocks.map(({ id }) => id))
  })

  it.each(clocks)('are those of its clock, thousands of them: $kind', (frames) => {
    const run = simulate({ scene: 'fall', duration: 14, frames })
    const { time, stateTime, frames: count } = run
    const own = clockOf(run.experiment.frames).start()
    // The loop reads 1024 of them at once.
    expect(count).toBeGreaterThan(1200)
    for (let row = 1; row < count; row++) {
      own.next()
      if (time[row] !== own.time) expect([row, time[row]]).toEqual([row, own.time])
    }
    expect(time[count]).toBe(14)
    expect(stateTime).toEqual(time)
  })

  const fall = (duration: number) =>
    simulate({ scene: 'fall', duration, frames: { kind: 'steady', fps: 10 } })
  const way = (t: number) => 0.5 * 9.81 * t * t

  it.each([
    // A few ulps more or less are the rounding of sums of frames; a billionth of a frame is a frame of its own.
    { duration: 0.3, frames: 3, end: 0.3 },
    { duration: 0.1 + 0.2, frames: 3, end: 0.3 },
    { duration: 0.3 + 5e-11, frames: 4, end: 0.3 + 5e-11 },
    { duration: 0.3 - 5e-11, frames: 3, end: 0.3 - 5e-11 },
    { duration: 0.3 + 5e-10, frames: 4, end: 0.3 + 5e-10 },
    { duration: 0.3 - 5e-10, frames: 3, end: 0.3 - 5e-10 },
    { duration: 0.05, frames: 1, end: 0.05 },
  ])('end with the run, but for rounding: after $duration s', ({ duration, frames, end }) => {
    const run = fall(duration)
    expect(run.frames).toBe(frames)
    expect(last(run.time)).toBe(duration)
    expect(last(run.s)).toBeCloseTo(way(end), 13)
  })

  it('may have no length', () => {
    // The generator's first draw for this seed is 0: the frame is shorter than the mean by all of it.
    const frames: FramesChoice = { kind: 'jitter', fps: 10, amount: 1, seed: 3320720970 }
    const run = simulate({ scene: 'ramp', parameters: { speed: 1 }, duration: 3, frames })
    expect([run.time[1], run.s[1], run.v[1]]).toEqual([0, 0, 1])
    expect(last(run.time)).toBe(3)
    expect(run.steps).toBe(run.frames)
  })

  it('may be more than its clock told: by chance, or by one long frame that never came', () => {
    for (let seed = 1; seed <= 20; seed++) {
      const frames: FramesChoice = { kind: 'jitter', fps: 100, amount: 1, seed }
      const run = simulate({ scene: 'fall', duration: 1, frames })
      for (const column of [run.time, run.stateTime, run.s, run.v, run.drawnS, run.heat])
        expect(column.length).toBe(run.frames + 1)
      expect(last(run.time)).toBe(1)
      expect(last(run.s)).toBeCloseTo(way(1), 12)
    }
  })
})

const policies: Timestep[] = [
  { kind: 'per-frame', step: 1 / 25 },
  { kind: 'variable' },
  { kind: 'capped', cap: 0.03 },
  { kind: 'substeps', step: 1 / 170 },
  { kind: 'fixed', step: 1 / 170 },
  { kind: 'tolerance', tolerance: 1e-6 },
]

describe('the time of the outcome', () => {
  const kicked: Experiment = {
    scene: 'ramp',
    parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
    frames: { kind: 'steady', fps: 25 },
    duration: 2,
  }
  const angle = Math.PI / 12
  const stop = 5 / (9.81 * (Math.sin(angle) + 0.5 * Math.cos(angle)))

  it('is tested with every policy', () => {
    expect(policies.map(({ kind }) => kind)).toEqual(timesteps.map(({ id }) => id))
  })

  it.each(policies)(
    'is the instant of the stop, on the clock of the physics: $kind',
    (timestep) => {
      const { outcome } = simulate({ ...kicked, timestep })
      expect(outcome.kind).toBe('at-rest')
      expect(outcome.time).toBeCloseTo(stop, 13)
    },
  )

  it.each(policies)(
    'is that of leaving the track, where everything then stands: $kind',
    (timestep) => {
      const launched: Experiment = {
        scene: 'half-pipe',
        parameters: { position: 0, speed: 9 },
        integrator: 'rk4',
        frames: { kind: 'steady', fps: 25 },
        timestep,
        duration: 2,
      }
      const { outcome, stateTime, drawnS, s } = simulate(launched)
      expect(outcome.kind).toBe('left-the-track')
      const fine = simulate({ ...launched, timestep: { kind: 'substeps', step: 1e-4 } }).outcome
        .time
      // The error of rk4 in steps of 0.04 s at the most.
      expect(outcome.time).toBeCloseTo(fine, 4)
      expect(last(stateTime)).toBe(outcome.time)
      expect(last(drawnS)).toBe(Math.PI)
      expect(last(s)).toBe(Math.PI)
    },
  )

  it('is the present as long as the block moves', () => {
    const { outcome, stateTime } = simulate({ scene: 'fall', duration: 1.5 })
    expect(outcome).toEqual({ kind: 'moving', time: last(stateTime) })
  })
})

describe('a run that the caller drives', () => {
  it('counts frames and steps after it has ended, but takes none', () => {
    const game = createRun({ scene: 'half-pipe', parameters: { position: 0, speed: 20 } })
    for (let i = 0; i < 30; i++) game.frame(1 / 60)
    const { steps, evaluations, drawnS, outcome } = game
    expect(game.ended).toBe(true)
    for (let i = 0; i < 30; i++) game.frame(1 / 60)
    expect(game.frames).toBe(60)
    expect([game.steps, game.evaluations, game.drawnS, game.outcome]).toEqual([
      steps,
      evaluations,
      drawnS,
      outcome,
    ])
    expect(game.frameDuration).toBe(1 / 60)
  })

  it('has diverged where no real motion gets to, at a speed that one may have', () => {
    const game = createRun({ scene: 'fall' })
    game.frame(1e11)
    expect(game.outcome.kind).toBe('moving')
    // ½ · 9.81 · 10²⁴ m, at 10¹³ m/s.
    game.frame(9e11)
    expect(game.outcome.kind).toBe('diverged')
    expect(game.motion.s).toBeGreaterThan(1e24)
    expect(game.motion.s).toBeLessThan(1e25)
  })

  it('goes on stepping a block at rest without moving it', () => {
    const game = createRun({ scene: 'ramp', parameters: { angle: 0, speed: 1 } })
    for (let i = 0; i < 120; i++) game.frame(1 / 60)
    const { s } = game.motion
    const { heat, outcome, evaluations } = game
    expect(outcome.kind).toBe('at-rest')
    expect(game.ended).toBe(false)
    game.frame(5)
    expect(game.motion.s).toBe(s)
    expect([game.heat, game.outcome, game.evaluations]).toEqual([heat, outcome, evaluations])
    expect(game.steps).toBe(121)
    expect(game.stateTime).toBe(game.time)
    // μk m g × the way slid is what it had.
    expect(heat).toBeCloseTo(0.5, 14)
  })

  it.each([NaN, -1e-300, Infinity])('refuses a frame of %s s in so many words', (duration) => {
    const game = createRun({ scene: 'ramp' })
    expect(() => {
      game.frame(duration)
    }).toThrow(
      `A frame of ${duration}: a frame lasts a finite number of seconds, 0 or more, and so does the run.`,
    )
    expect([game.frames, game.time]).toEqual([0, 0])
  })
})
