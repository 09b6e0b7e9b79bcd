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
import { measured, published } from './measured.ts'
import { hardCase, largest, largestError, last, methods, secondOrder } from './support.ts'

const ids = integrators.map(({ id }) => id)

describe('14 a joint and a stop inside the same step', () => {
  const { id: name, experiments } = hardCase('joint-and-stop-in-a-step')
  const [once, ten, hundred] = experiments as [Experiment, Experiment, Experiment]

  it('both joints and the stop are in the first frame, in their order', () => {
    const [step] = traceFrame(once, 1)
    // Between them steps that would be too long for the bend are cut.
    const { stretches } = step!
    const events = stretches.flatMap(({ ends }) => (ends && ends !== 'cut' ? [ends] : []))
    expect(events).toEqual(['joint', 'joint', 'stop'])
    measured(name, 'found', [once.integrator!], events.length, { atLeast: 3, atMost: 3 })
    const bendEnd = 0.2 + 0.5 * 30 * (Math.PI / 180)
    const afterJoints = stretches.filter((_, i) => stretches[i - 1]?.ends === 'joint')
    expect(afterJoints.map(({ tries }) => tries[0]!.from.s)).toEqual([0.2, bendEnd])
  })

  it.each(methods)('$id rests, however many of them a step holds', (method) => {
    const { id, orderWithSpeed, evaluations } = method
    const truth = exact(once, 3).s
    const errors = [once, ten, hundred].map((experiment) => {
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      measured(name, 'speed', [id], Math.abs(last(run.v)), { atMost: 0 })
      // Some forty steps, and three jumps found within a dozen tries each.
      expect(run.evaluations).toBeLessThan((43 + 3 * 12) * Math.max(6, evaluations.least))
      return Math.abs(last(run.s) - truth)
    })
    // The block goes 0.33 m. On the bend the law changes at a rate of (1 + μ) v/R, up to 6.4/s: a second does not resolve
    // it, a tenth of one leaves some 0.64ᵖ of the way, a hundredth 0.064ᵖ.
    const bounds = [1, 0.64, 0.064].map((rate) => 0.33 * rate ** orderWithSpeed)
    for (const [i, fps] of [1, 10, 100].entries())
      measured(name, 'error', [id, `${fps} fps`], errors[i]!, { atMost: bounds[i]! })
  })

  it.each(secondOrder)('$id passes two joints at one place as if there were none', ({ id }) => {
    const { id: name, experiments } = hardCase('joints-of-no-bend')
    for (const experiment of experiments) {
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      expect(last(run.v)).toBe(0)
      // v²/(2 μ g) = 2.5 m after v/(μ g) = 1 s; 60 steps of some roundings.
      const off = { place: Math.abs(last(run.s) - 2.5), time: Math.abs(run.outcome.time - 1) }
      measured(name, 'place', [id], off.place, { atMost: 60 * 2 * Number.EPSILON })
      measured(name, 'time', [id], off.time, { atMost: 60 * Number.EPSILON })
    }
  })
})

describe('15 a stop exactly at a frame’s end, and exactly at a joint', () => {
  it.each(secondOrder)('$id rests from the frame’s end on', ({ id }) => {
    const { id: name, experiments } = hardCase('stop-at-a-frames-end')
    for (const experiment of experiments) {
      const { fps } = experiment.frames as { fps: number }
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      const off = { place: Math.abs(last(run.s) - 2.5), time: Math.abs(run.outcome.time - 1) }
      const each = [id, `${fps} fps`]
      measured(name, 'place', each, off.place, { atMost: fps * 2 * Number.EPSILON })
      measured(name, 'time', each, off.time, { atMost: fps * Number.EPSILON })
      // Neither a frame late nor for a moment only.
      for (let row = fps + 1; row <= run.frames; row++)
        expect([run.s[row], run.v[row]]).toEqual([last(run.s), 0])
    }
  })

  it.each(['located', 'clamped'] as const)(
    '%s: v = 0 to the bit at the frame’s end is a stop',
    (stopping) => {
      // 5 m/s less 5 m/s² × 1/64 s, 64 times: no rounding at all.
      const { id: name, experiments } = hardCase('stop-at-a-frames-end')
      const experiment = experiments[1]!
      const run = simulate({ ...experiment, stopping })
      measured(name, 'speed', [stopping], Math.abs(run.v[64]!), { atMost: 0 })
      expect(run.s[64]).toBe(2.5)
      expect(run.outcome).toEqual({ kind: 'at-rest', time: 1 })
    },
  )

  it.each(secondOrder)('$id rests at the joint', ({ id }) => {
    const { id: name, experiments } = hardCase('stop-at-a-joint')
    for (const experiment of experiments) {
      const { length } = experiment.parameters as { length: number }
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      expect(last(run.v)).toBe(0)
      // Within the rounding of fifty steps, on whichever side.
      const off = Math.abs(last(run.s) - length)
      measured(name, 'place', [id], off, { atMost: 50 * 2 * Number.EPSILON })
      const from = Math.ceil(run.outcome.time * (experiment.frames as { fps: number }).fps)
      const creep = largest(run.s.subarray(from).map((s) => s - last(run.s)))
      measured(name, 'creep', [id], creep, { atMost: 0 })
    }
  })

  it.each(ids)('%s crosses a joint at a frame’s end without a trace', (integrator) => {
    const { id: name, experiments } = hardCase('joint-at-a-frames-end')
    const [experiment] = experiments as [Experiment]
    for (const { id: stopping } of stoppings) {
      const run = simulate({ ...experiment, integrator, stopping })
      expect(run.s[8]).toBeCloseTo(2, 14)
      const rule = [integrator, stopping]
      measured(name, 'speed', rule, largest(run.v.map((v) => v - 1)), { atMost: 0 })
      measured(name, 'place', rule, largestError(run), { atMost: 16 * 4 * Number.EPSILON })
      // Nothing is to be searched for: the frame that begins at the joint begins on the next piece.
      const { least, most } = methods.find(({ id }) => id === integrator)!.evaluations
      const each = Math.max(least, Math.min(most, 6))
      expect(run.evaluations).toBeLessThanOrEqual((run.steps + 4) * each)
    }
  })

  it('a lip reached exactly at a frame’s end is left there, since the track ends at it', () => {
    // Without gravity and friction the speed is kept: one frame of a second is a quarter of the circle to the bit.
    const game = createRun({
      scene: 'half-pipe',
      parameters: { radius: 1, gravity: 0, position: 0, speed: Math.PI / 2 },
    })
    game.frame(1)
    expect(game.motion.s).toBe(Math.PI / 2)
    expect(game.outcome).toEqual({ kind: 'left-the-track', time: 1 })
    expect(game.motion.s).toBe(Math.PI / 2)
  })
})

published('jumps')
