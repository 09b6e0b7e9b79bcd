import { describe, expect, it } from 'vitest'
import { createRun, exact, frameClocks, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { measured, published } from './measured.ts'
import {
  firstOrder,
  hardCase,
  largest,
  largestError,
  last,
  methods,
  secondOrder,
} from './support.ts'

describe.each([hardCase('half-second-hitch'), hardCase('five-fps'), hardCase('wild-jitter')])(
  '7 $label',
  ({ id: name, experiments }) => {
    const [rough, paper, smooth] = experiments as [Experiment, Experiment, Experiment]

    it.each(secondOrder)('$id, located: ends where it ends at a steady 60 fps', ({ id }) => {
      const run = simulate({ ...rough, integrator: id })
      const other = simulate({ ...smooth, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      // Some 180 steps to the stop, each off by an ulp of 1.6 m at the most.
      const rounding = 180 * 2 * Number.EPSILON
      measured(name, 'located', [id], largestError(run), { atMost: rounding })
      const apart = Math.abs(last(run.s) - last(other.s))
      measured(name, 'same', [id], apart, { atMost: rounding })
      expect(Math.abs(run.outcome.time - other.outcome.time)).toBeLessThanOrEqual(rounding)
    })

    it.each(firstOrder)('$id: does not', ({ id }) => {
      const run = simulate({ ...rough, integrator: id })
      const other = simulate({ ...smooth, integrator: id })
      // Off by ½ a Σ Δt²: centimetres at 60 fps, and another sum for other frames.
      const off = Math.abs(last(run.s) - exact(rough, 3).s)
      measured(name, 'euler', [id], off, { above: 0.01 })
      expect(last(run.s)).not.toBe(last(other.s))
    })

    it('the paper’s step does not, and never rests', () => {
      const run = simulate(paper)
      expect(run.outcome.kind).toBe('moving')
      const off = Math.abs(last(run.s) - exact(paper, 3).s)
      measured(name, 'paper', [paper.integrator!], off, { above: 0.01 })
    })
  },
)

describe('8 ten million frames', () => {
  const { id: name, experiments } = hardCase('long-clock')
  const count = samples(500_000, 10_000_000)

  it.each(experiments)('the run’s clock is rounded once: $frames.fps fps', (experiment) => {
    const { frames } = experiment as { frames: { fps: number } }
    const run = simulate(experiment)
    expect(run.frames).toBeGreaterThan(900_000)
    const off = largest(run.time.map((time, row) => time - row / frames.fps))
    measured(name, 'run', [`${frames.fps} fps`], off, { atMost: 0 })
    expect(run.stateTime.every((time, row) => time === run.time[row])).toBe(true)
  })

  it.each([60, 144])('the clock counts frames of 1/%i s, however many there are', (fps) => {
    const steady = frameClocks.find(({ id }) => id === 'steady')!
    const frames = steady.start({ fps } as never)
    for (let i = 0; i < count; i++) frames.next()
    measured(name, 'clock', [`${fps} fps`], Math.abs(frames.time - count / fps), { atMost: 0 })
  })

  it.each([60, 144])('a game loop of many frames of 1/%i s is off by one rounding', (fps) => {
    const game = createRun(experiments[0]!)
    const dt = 1 / fps
    for (let i = 0; i < count; i++) game.frame(dt)
    // So many times the rounded 1/fps, exactly, in units of 2⁻⁷⁰ s.
    const sum = Number(BigInt(dt * 2 ** 70) * BigInt(count)) / 2 ** 70
    const ulp = 2 ** (Math.floor(Math.log2(sum)) - 52)
    measured(name, 'loop', [`${fps} fps`], Math.abs(game.time - sum), { atMost: ulp })
    expect(game.frames).toBe(count)
    expect(game.stateTime).toBe(game.time)
  })
})

describe('17 the spiral of death: steps of 1 ms, frames of 2 s', () => {
  const { id: name, experiments } = hardCase('spiral-of-death')
  const [unbounded, bounded] = experiments as [Experiment, Experiment]
  const exactly = (value: number) => ({ atLeast: value, atMost: value })

  it.each(methods)(
    '$id: takes all steps, or as many as it may and says what it dropped',
    ({ id }) => {
      const whole = simulate({ ...unbounded, integrator: id })
      measured(name, 'whole', [id], whole.steps, exactly(20_000))
      expect(whole.lostTime).toBe(0)
      expect(last(whole.stateTime)).toBe(20)
      const late = simulate({ ...bounded, integrator: id })
      expect(late.frames).toBe(10)
      measured(name, 'steps', [id], late.steps / late.frames, exactly(50))
      // 1950 steps of 1 ms a frame, counted and multiplied once.
      measured(name, 'lost', [id], late.lostTime, exactly(19_500 * 0.001))
      expect(last(late.stateTime)).toBe(500 * 0.001)
      // The same steps, only fewer: where the whole run was after 500 of them.
      const short = simulate({ ...unbounded, integrator: id, duration: 0.5 })
      measured(name, 'same', [id], Math.abs(last(late.s) - last(short.s)), { atMost: 0 })
    },
  )

  it('a frame of a million seconds still ends', () => {
    const game = createRun(unbounded)
    game.frame(1e6)
    expect(game.steps).toBe(100_000)
    expect(game.lostTime + game.stateTime).toBe(1e6)
  })
})

published('frames', 'long-clock')
