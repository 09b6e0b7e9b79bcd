import { describe, expect, it } from 'vitest'
import {
  createRun,
  exact,
  integrators,
  simulate,
  stoppings,
  traceFrame,
} from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { hardCase, largestError, last, methods, secondOrder } from './support.ts'

const ids = integrators.map(({ id }) => id)

describe('14 a joint and a stop inside the same step', () => {
  const { experiments } = hardCase('joint-and-stop-in-a-step')
  const [once, ten, hundred] = experiments as [Experiment, Experiment, Experiment]

  it('both joints and the stop are in the first frame, in their order', () => {
    const [step] = traceFrame(once, 1)
    expect(step!.stretches.map(({ jump }) => jump)).toEqual(['joint', 'joint', 'stop'])
    const bendEnd = 0.2 + 0.5 * 30 * (Math.PI / 180)
    expect(step!.stretches.slice(1).map(({ tries }) => tries[0]!.from.s)).toEqual([0.2, bendEnd])
  })

  it.each(methods)('$id rests, however many of them a step holds', ({ id, orderWithSpeed }) => {
    const truth = exact(once, 3).s
    const errors = [once, ten, hundred].map((experiment) => {
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      expect(last(run.v)).toBe(0)
      // Some forty steps, and three jumps found within a dozen tries each.
      expect(run.evaluations).toBeLessThan((43 + 3 * 12) * 6)
      return Math.abs(last(run.s) - truth)
    })
    // The block goes 0.33 m. On the bend the law changes at a rate of (1 + μ) v/R, up to 6.4/s: a second does not resolve
    // it, a tenth of one leaves some 0.64ᵖ of the way, a hundredth 0.064ᵖ.
    expect(errors[0]).toBeLessThan(0.33)
    expect(errors[1]).toBeLessThan(0.33 * 0.64 ** orderWithSpeed)
    expect(errors[2]).toBeLessThan(0.33 * 0.064 ** orderWithSpeed)
  })

  it.each(secondOrder)('$id passes two joints at one place as if there were none', ({ id }) => {
    for (const experiment of hardCase('joints-of-no-bend').experiments) {
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      expect(last(run.v)).toBe(0)
      // v²/(2 μ g) = 2.5 m after v/(μ g) = 1 s; 60 steps of some roundings.
      expect(Math.abs(last(run.s) - 2.5)).toBeLessThanOrEqual(60 * 2 * Number.EPSILON)
      expect(Math.abs(run.outcome.time - 1)).toBeLessThanOrEqual(60 * Number.EPSILON)
    }
  })
})

describe('15 a stop exactly at a frame’s end, and exactly at a joint', () => {
  it.each(secondOrder)('$id rests from the frame’s end on', ({ id }) => {
    for (const experiment of hardCase('stop-at-a-frames-end').experiments) {
      const { fps } = experiment.frames as { fps: number }
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      expect(Math.abs(run.outcome.time - 1)).toBeLessThanOrEqual(fps * Number.EPSILON)
      expect(Math.abs(last(run.s) - 2.5)).toBeLessThanOrEqual(fps * 2 * Number.EPSILON)
      // Neither a frame late nor for a moment only.
      for (let row = fps + 1; row <= run.frames; row++)
        expect([run.s[row], run.v[row]]).toEqual([last(run.s), 0])
    }
  })

  it.each(['located', 'clamped'] as const)(
    '%s: v = 0 to the bit at the frame’s end is a stop',
    (stopping) => {
      // 5 m/s less 5 m/s² × 1/64 s, 64 times: no rounding at all.
      const experiment = hardCase('stop-at-a-frames-end').experiments[1]!
      const run = simulate({ ...experiment, stopping })
      expect(run.v[64]).toBe(0)
      expect(run.s[64]).toBe(2.5)
      expect(run.outcome).toEqual({ kind: 'at-rest', time: 1 })
    },
  )

  it.each(secondOrder)('$id rests at the joint', ({ id }) => {
    for (const experiment of hardCase('stop-at-a-joint').experiments) {
      const { length } = experiment.parameters as { length: number }
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      expect(last(run.v)).toBe(0)
      // Within the rounding of fifty steps, on whichever side.
      expect(Math.abs(last(run.s) - length)).toBeLessThanOrEqual(50 * 2 * Number.EPSILON)
      const from = Math.ceil(run.outcome.time * (experiment.frames as { fps: number }).fps)
      expect(new Set(run.s.subarray(from)).size).toBe(1)
    }
  })

  it.each(ids)('%s crosses a joint at a frame’s end without a trace', (integrator) => {
    const [experiment] = hardCase('joint-at-a-frames-end').experiments as [Experiment]
    for (const { id: stopping } of stoppings) {
      const run = simulate({ ...experiment, integrator, stopping })
      expect(run.s[8]).toBeCloseTo(2, 14)
      expect(run.v.every((v) => v === 1)).toBe(true)
      expect(largestError(run)).toBeLessThanOrEqual(16 * 4 * Number.EPSILON)
      // Nothing is to be searched for: the frame that begins at the joint begins on the next piece.
      const most = methods.find(({ id }) => id === integrator)!.evaluations.most
      expect(run.evaluations).toBeLessThanOrEqual((run.steps + 4) * Math.min(most, 6))
    }
  })

  it('a lip reached exactly at a frame’s end is left in the next', () => {
    // Without gravity and friction the speed is kept: one frame of a second is a quarter of the circle to the bit.
    const game = createRun({
      scene: 'half-pipe',
      parameters: { radius: 1, gravity: 0, position: 0, speed: Math.PI / 2 },
    })
    game.frame(1)
    expect(game.motion.s).toBe(Math.PI / 2)
    expect(game.outcome.kind).toBe('moving')
    game.frame(1)
    expect(game.outcome).toEqual({ kind: 'left-the-track', time: 1 })
    expect(game.motion.s).toBe(Math.PI / 2)
  })
})
