/** Policies that combine a step with a bound, as engines do: what a second of game holds, by hand. */
import { describe, expect, it } from 'vitest'
import { createRun, simulate } from '../../src/physics/index.ts'
import type { Experiment, FramesChoice, Timestep } from '../../src/physics/index.ts'
import { last } from './truth.ts'

const sliding: Experiment = { scene: 'ramp', parameters: { speed: 1 }, duration: 6 }
const run = (timestep: Timestep, frames: FramesChoice) => simulate({ ...sliding, timestep, frames })
const steady = (fps: number): FramesChoice => ({ kind: 'steady', fps })
const hitching: FramesChoice = { kind: 'hitch', fps: 60, every: 0.8, length: 0.5 }

describe('fixed steps with a cap on the frame', () => {
  it('of 1/3 s, at 2 fps, lose 1/3 s of each second: the game runs at two thirds', () => {
    const result = run({ kind: 'fixed', step: 0.02, cap: 1 / 3 }, steady(2))
    // Twelve frames of 1/2 s, of which 1/3 s each counts: 4 s, and 200 steps.
    expect(result.lostTime).toBeCloseTo(2, 13)
    expect(result.steps).toBe(200)
    expect(last(result.stateTime)).toBeCloseTo(6 * 0.6667, 3)
  })

  it('carry what is left of a cut frame over', () => {
    const game = createRun({ ...sliding, timestep: { kind: 'fixed', step: 0.02, cap: 0.05 } })
    // 0.05 s is two steps and a half, three times.
    expect([0.5, 0.5, 0.05].map((frame) => (game.frame(frame), game.steps))).toEqual([2, 5, 7])
    expect(game.lostTime).toBeCloseTo(0.9, 15)
  })

  it('and a most of steps lose to both', () => {
    const game = createRun({
      ...sliding,
      timestep: { kind: 'fixed', step: 0.02, cap: 0.1, maxSteps: 3 },
    })
    game.frame(0.5)
    expect(game.steps).toBe(3)
    // The cap takes 0.4 s, the bound two of the five steps that are due.
    expect(game.lostTime).toBeCloseTo(0.44, 14)
    game.frame(0.02)
    expect(game.steps).toBe(4)
    expect(game.lostTime).toBeCloseTo(0.44, 14)
  })
})

describe('substeps with a most of steps', () => {
  const timestep: Timestep = { kind: 'substeps', step: 1 / 60, maxSteps: 6 }

  it('of six sixtieths, at 5 fps, lose half of each second', () => {
    const result = run(timestep, steady(5))
    expect(result.lostTime).toBeCloseTo(3, 13)
    expect(last(result.stateTime)).toBeCloseTo(3, 13)
    expect(result.steps).toBe(6 * 30)
  })

  it('at 45 fps take two parts of 11.1 ms', () => {
    const game = createRun({ ...sliding, timestep })
    game.frame(1 / 45)
    expect(game.steps).toBe(2)
    expect(game.motion.dt).toBe(1 / 90)
    expect(game.lostTime).toBe(0)
  })

  it('take six whole steps of a frame that is a little longer', () => {
    const game = createRun({ ...sliding, timestep })
    game.frame(0.101)
    expect(game.steps).toBe(6)
    expect(game.motion.dt).toBeCloseTo(1 / 60, 15)
    expect(game.lostTime).toBeCloseTo(0.001, 15)
  })
})

describe('a bound that is left out', () => {
  it.each([
    [
      { kind: 'fixed', step: 0.02 },
      { kind: 'fixed', step: 0.02, maxSteps: 100_000, cap: 60 },
    ],
    [
      { kind: 'substeps', step: 0.02 },
      { kind: 'substeps', step: 0.02, maxSteps: 100_000 },
    ],
  ] satisfies [Timestep, Timestep][])('is none: %o', (without, largest) => {
    const one = run(without, hitching)
    const other = run(largest, hitching)
    expect(other).toEqual(one)
    expect(one.lostTime).toBe(0)
    // Not even for a game that hands in a frame of more than a minute.
    const game = createRun({ ...sliding, timestep: without })
    game.frame(100)
    expect(game.lostTime).toBe(0)
    expect(game.steps).toBe(5000)
  })
})
