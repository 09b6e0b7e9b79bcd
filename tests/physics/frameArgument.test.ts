import { describe, expect, it } from 'vitest'
import { createRun } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const experiment: Experiment = { scene: 'ramp', integrator: 'rk4' }

/** Everything that a run shows of itself. */
function shown(run: ReturnType<typeof createRun>) {
  const { time, stateTime, drawnS, lostTime, frames, steps, heat, evaluations, outcome } = run
  const { s, v } = run.motion
  return { time, stateTime, drawnS, lostTime, frames, steps, heat, evaluations, outcome, s, v }
}

const refused: { name: string; given: unknown; says: RegExp }[] = [
  { name: 'a string', given: '0.016', says: /0\.016/ },
  { name: 'an empty string', given: '', says: /""|''|empty/ },
  { name: 'a Number object', given: new Number(0.016), says: /0\.016|object/i },
  { name: 'a list', given: [0.016], says: /0\.016|list/i },
  { name: 'an object', given: { valueOf: () => 0.016 }, says: /object/i },
  { name: 'true', given: true, says: /true/ },
  { name: 'null', given: null, says: /null/ },
  { name: 'undefined', given: undefined, says: /undefined/ },
  { name: 'a bigint', given: 1n, says: /1/ },
  { name: 'a symbol', given: Symbol('frame'), says: /frame/ },
  { name: 'NaN', given: NaN, says: /NaN/ },
  { name: 'a negative number', given: -1, says: /[-−]1/ },
  { name: 'the smallest negative number', given: -5e-324, says: /[-−]5e-324/ },
  { name: 'Infinity', given: Infinity, says: /Infinity/ },
  { name: 'minus Infinity', given: -Infinity, says: /[-−]Infinity/ },
]

describe('a frame that lasts no finite number of seconds, 0 or more, is refused', () => {
  it.each(refused)('$name', ({ given, says }) => {
    const run = createRun(experiment)
    const untouched = createRun(experiment)
    run.frame(1 / 60)
    untouched.frame(1 / 60)
    let thrown: unknown
    try {
      run.frame(given as number)
    } catch (error) {
      thrown = error
    }
    expect(thrown instanceof RangeError || thrown instanceof TypeError).toBe(true)
    expect((thrown as Error).message).toMatch(says)
    expect(shown(run)).toEqual(shown(untouched))
    run.frame(1 / 60)
    untouched.frame(1 / 60)
    expect(shown(run)).toEqual(shown(untouched))
  })

  it('but not one of no length, of either sign', () => {
    for (const nothing of [0, -0]) {
      const run = createRun(experiment)
      run.frame(1 / 60)
      const { s, v } = run.motion
      run.frame(nothing)
      expect(run.frames).toBe(2)
      expect(run.time).toBe(1 / 60)
      expect([run.motion.s, run.motion.v]).toEqual([s, v])
    }
  })
})

it('a frame that the clock has no number for is refused, and the run goes on as before', () => {
  const still: Experiment = { scene: 'ramp', parameters: { angle: 0 } }
  const run = createRun(still)
  const untouched = createRun(still)
  run.frame(1e308)
  untouched.frame(1e308)
  expect(() => {
    run.frame(1e308)
  }).toThrow(RangeError)
  expect(() => {
    run.frame(1e308)
  }).toThrow(/1e\+?308/)
  expect(shown(run)).toEqual(shown(untouched))
  run.frame(1)
  expect(run.time).toBe(1e308)
  expect(run.frames).toBe(2)
})

it('a block that a frame carries beyond all numbers has diverged, and shows none that is NaN', () => {
  const run = createRun({ scene: 'ramp' })
  run.frame(1e308)
  expect(run.outcome.kind).toBe('diverged')
  const { s, v } = run.motion
  expect([s, v, run.heat, run.time, run.stateTime, run.drawnS].some(Number.isNaN)).toBe(false)
})

it('a run that the caller drives takes small steps, whatever its scene’s default duration', () => {
  for (const scene of ['fall', 'ramp', 'run-out', 'half-pipe', 'spring'] as const) {
    const run = createRun({ scene, timestep: { kind: 'fixed', step: 1e-7 } })
    run.frame(1e-6)
    expect(run.steps, scene).toBe(10)
    const parts = createRun({ scene, timestep: { kind: 'substeps', step: 1e-7 } })
    parts.frame(1e-6)
    expect(parts.steps, scene).toBe(10)
  }
})
