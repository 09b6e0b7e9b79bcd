import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { ExperimentError, limits, parseExperiment, simulate } from '../../src/physics/index.ts'
import type { Experiment, ResolvedExperiment } from '../../src/physics/index.ts'
import { experiments, work } from './experiments.ts'
import { changes, mutate, nested } from './mutated.ts'
import { check } from './runs.ts'
import { TOGETHER, wrongPaths } from './wrongPaths.ts'

describe('mutated experiments', () => {
  it('are each valid and run, or refused with every wrong path and no other', () => {
    check(1, fc.tuple(experiments('wild'), changes), ([experiment, all]) => {
      const value = mutate(experiment, all)
      const expected = wrongPaths(value)
      let parsed: ResolvedExperiment
      try {
        parsed = parseExperiment(value)
      } catch (error) {
        expectRefusal(error, expected)
        return
      }
      expect(expected).toEqual([])
      // What it takes, it takes again, from JSON.
      expect(parseExperiment(JSON.parse(JSON.stringify(parsed)))).toEqual(parsed)
      const asked = work(parsed)
      expect(asked.frames).toBeLessThanOrEqual(limits.frames)
      expect(asked.steps).toBeLessThanOrEqual(limits.steps)
      // A changed duration may ask for a million frames, which is allowed and takes a while.
      if (asked.frames <= 2000 && asked.steps <= 5000)
        expect(simulate(value as Experiment).s.every(Number.isFinite)).toBe(true)
    })
  })
})

function expectRefusal(error: unknown, expected: readonly string[]): void {
  if (!(error instanceof ExperimentError)) throw error
  const paths = error.problems.map(({ path }) => path)
  expect(paths.length).toBeGreaterThan(0)
  const alone = paths.filter((path) => expected.includes(path) || !TOGETHER.includes(path))
  expect(alone.sort()).toEqual([...expected].sort())
  // What is valid in itself may take too much work, of which the duration is to blame.
  for (const { path, message } of error.problems)
    if (message.includes('evaluations')) expect(path).toBe('duration')
  // For people: a line for each of the first twenty, none of them long, whatever was given.
  expect(error.message.split('\n').length).toBeLessThanOrEqual(400)
  expect(error.message.length).toBeLessThan(21 * 400)
}

describe('the work of reading', () => {
  /** How often an object's properties are read, listed or asked for. */
  function counted<T extends object>(value: T): { value: T; count: () => number } {
    let count = 0
    const handler = Object.fromEntries(
      (['get', 'has', 'ownKeys', 'getOwnPropertyDescriptor'] as const).map((trap) => [
        trap,
        (...args: unknown[]) => {
          count++
          return (Reflect[trap] as (...args: unknown[]) => unknown)(...args)
        },
      ]),
    )
    return { value: new Proxy(value, handler), count: () => count }
  }

  it('a list that is too long is not looked through', () => {
    for (const length of [100_001, 1e6, 1e9]) {
      const { value: durations, count } = counted(new Array<number>(length))
      const read = () => parseExperiment({ scene: 'ramp', frames: { kind: 'recorded', durations } })
      expect(read).toThrow(/does not hold 1…100000 numbers/)
      expect(count()).toBeLessThan(20)
    }
  })

  it('a list of the longest allowed is read once', () => {
    const { value: durations, count } = counted(new Array<number>(100_000).fill(0.001))
    parseExperiment({ scene: 'ramp', frames: { kind: 'recorded', durations } })
    // An index asks whether it is there and for its value.
    expect(count()).toBeLessThan(3 * 100_000)
  })

  it('a deep value is not descended into', () => {
    const { value, count } = counted({ deep: nested(100_000) })
    expect(() => parseExperiment({ scene: 'ramp', parameters: { angle: value } })).toThrow(
      /^parameters.angle: an object is not a number$/,
    )
    expect(count()).toBe(0)
    expect(() => parseExperiment(nested(100_000))).toThrow(ExperimentError)
  })

  it('an experiment is not changed, and what it becomes shares nothing with it', () => {
    const given = Object.freeze({
      scene: 'ramp',
      parameters: Object.freeze({ angle: 20 }),
      frames: Object.freeze({ kind: 'recorded', durations: Object.freeze([0.01, 0.02]) }),
    })
    const parsed = parseExperiment(given)
    expect(parsed.parameters).not.toBe(given.parameters)
    expect((parsed.frames as { durations: unknown }).durations).not.toBe(given.frames.durations)
  })

  it('text of characters of two units is cut like any other', () => {
    for (const length of [39, 40, 41, 79, 80, 81, 100_000]) {
      let message = ''
      try {
        parseExperiment({ scene: '🤖'.repeat(length), ['🤖'.repeat(length)]: 1 })
      } catch (error) {
        message = (error as Error).message
      }
      const longest = /🤖+/gu
      for (const [run] of message.matchAll(longest))
        expect(Array.from(run).length).toBe(Math.min(40, length))
    }
  })

  it.each([
    // Two million steps in frames that are all in the first minute.
    { frames: { kind: 'hitch', fps: 1000, every: 60, length: 60 }, step: 1e-7, duration: 60 },
    { frames: { kind: 'hitch', fps: 1000, every: 60, length: 60 }, step: 1e-5, duration: 59 },
    {
      frames: { kind: 'recorded', durations: [...new Array<number>(9999).fill(1e-3), 60] },
      step: 1e-6,
      duration: 10,
    },
  ])('no run takes more steps than are allowed: $frames.kind', ({ frames, step, duration }) => {
    expect(() =>
      parseExperiment({ scene: 'ramp', timestep: { kind: 'fixed', step }, frames, duration }),
    ).toThrow(/timestep.step: asks for [\d\s]+ steps, more than 5\s000\s000/)
  })

  it('the figure of a run that is far too long has all its digits', () => {
    expect(() =>
      parseExperiment({
        scene: 'ramp',
        duration: 1e6,
        frames: { kind: 'recorded', durations: [1e-5] },
        timestep: { kind: 'substeps', step: 1e-7 },
      }),
    ).toThrow(/asks for 100\s000\s000\s001 frames[^]*asks for 10\s100\s000\s000\s001 steps/)
  })
})
