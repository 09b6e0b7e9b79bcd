import { describe, expect, it } from 'vitest'
import { energyResidual, frameRateSpread } from '../../src/measure/index.ts'
import { exact, integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { measured, published } from './measured.ts'
import {
  firstOrder,
  hardCase,
  having,
  largestError,
  last,
  methods,
  largest,
  secondOrder,
} from './support.ts'

const ids = integrators.map(({ id }) => id)

/** Deceleration and time to the stop of a block that is kicked uphill: a = g (sin α + μ cos α). */
function braking({ parameters }: Experiment) {
  const { angle = 0, muKinetic = 0, speed = 0 } = parameters!
  const radians = (angle * Math.PI) / 180
  const a = 9.81 * (Math.sin(radians) + muKinetic * Math.cos(radians))
  return { a, time: Math.abs(speed) / a }
}

describe.each([hardCase('stops-on-the-flat'), hardCase('stops-uphill')])(
  '1 $label',
  ({ id: name, experiments }) => {
    const base = { ...experiments[0]!, stopping: 'located' } as const
    const { a, time } = braking(base)

    it.each(secondOrder)('$id, located: exact at any frame rate, at rest to the bit', ({ id }) => {
      for (const fps of [1, 5, 10, 30, 60, 144, 240, 1000]) {
        const run = simulate({ ...base, integrator: id, frames: { kind: 'steady', fps } })
        expect(run.outcome.kind).toBe('at-rest')
        expect(last(run.v)).toBe(0)
        // Constant acceleration between the jumps: an ulp of a position below 4 m for each of 640 steps.
        measured(name, 'located', [id, `${fps} fps`], largestError(run), {
          atMost: 640 * 4 * Number.EPSILON,
        })
        expect(Math.abs(run.outcome.time - time)).toBeLessThanOrEqual(640 * Number.EPSILON)
      }
      const { distance: spread } = frameRateSpread({ ...base, integrator: id })
      measured(name, 'spread', [id], spread, { atMost: 1e-12 })
    })

    it.each(firstOrder)('$id, located: rests, off by ½ a T Δt', ({ id }) => {
      for (const fps of [5, 30, 144]) {
        const run = simulate({ ...base, integrator: id, frames: { kind: 'steady', fps } })
        expect(run.outcome.kind).toBe('at-rest')
        const off = Math.abs(last(run.s) - exact(base, 3).s)
        // Each whole step is off by ½ a Δt², the last by less: between one step less and one more.
        measured(name, 'euler', [id, `${fps} fps`], off, {
          atLeast: (0.5 * a * (time - 1 / fps)) / fps,
          atMost: (0.5 * a * (time + 1 / fps)) / fps,
        })
      }
    })

    it.each(ids)('%s, clamped: rests, up to a frame off', (integrator) => {
      for (const fps of [5, 30, 144]) {
        const run = simulate({
          ...base,
          integrator,
          stopping: 'clamped',
          frames: { kind: 'steady', fps },
        })
        expect(run.outcome.kind).toBe('at-rest')
        expect(last(run.v)).toBe(0)
        expect(Math.abs(run.outcome.time - time)).toBeLessThanOrEqual(1 / fps)
        // A first-order method's own error, and the way of the last frame at less than a Δt.
        const dt = 1 / fps
        const off = Math.abs(last(run.s) - exact(base, 3).s)
        measured(name, 'clamped', [integrator, `${fps} fps`], off, { atMost: a * dt * (time + dt) })
      }
    })

    it.each(ids)('%s, naive: never rests', (integrator) => {
      const run = simulate({
        ...base,
        integrator,
        stopping: 'naive',
        frames: { kind: 'steady', fps: 60 },
      })
      expect(run.outcome.kind).toBe('moving')
      // Where v = 0 lies between two signs, a step ends beyond it, by one step's gain at the most: for several
      // evaluations a step, by their sum's.
      measured(name, 'naive', [integrator], largest(run.v.subarray(-60)), { above: 0 })
    })
  },
)

describe('2 stops and comes back', () => {
  const { id: name, experiments } = hardCase('comes-back')
  const base = experiments[0]!

  it.each(secondOrder)('$id, located: exact through the turn', ({ id }) => {
    for (const fps of [5, 30, 60, 144, 1000]) {
      const run = simulate({ ...base, integrator: id, frames: { kind: 'steady', fps } })
      expect(run.outcome.kind).toBe('moving')
      // Up to 3000 steps, an ulp of a position below 8 m each.
      measured(name, 'located', [id, `${fps} fps`], largestError(run), {
        atMost: 3000 * 4 * Number.EPSILON,
      })
    }
    const { distance: spread } = frameRateSpread({ ...base, integrator: id })
    measured(name, 'spread', [id], spread, { atMost: 1e-12 })
  })

  it.each(methods)(
    '$id, clamped: the turn is up to a frame late, so the way back is too',
    ({ id }) => {
      const dt = 1 / 30
      const run = simulate({
        ...base,
        integrator: id,
        stopping: 'clamped',
        frames: { kind: 'steady', fps: 30 },
      })
      const { s, v } = exact(base, 3)
      const off = Math.abs(last(run.s) - s)
      // A frame late at the final speed, and the first-order error ½ a T Δt of either leg, a below 8.1 m/s².
      measured(name, 'clamped', [id], off, {
        atLeast: 1e-6,
        atMost: dt * (Math.abs(v) + 0.5 * 8.1 * 3),
      })
    },
  )
})

describe('3 μk < tan α < μs', () => {
  const { id: name, experiments } = hardCase('held-or-sliding')
  const [still, down, up] = experiments as [Experiment, Experiment, Experiment]

  it.each(ids)('%s, located and clamped: held at rest, slides on once it slides', (integrator) => {
    for (const stopping of ['located', 'clamped'] as const) {
      const rule = [integrator, stopping]
      const held = simulate({ ...still, integrator, stopping })
      expect(held.outcome).toEqual({ kind: 'at-rest', time: 0 })
      measured(name, 'held', rule, largest(held.s), { atMost: 0 })
      const sliding = simulate({ ...down, integrator, stopping })
      expect(sliding.outcome.kind).toBe('moving')
      const gains = sliding.v.subarray(1).map((v, row) => v - sliding.v[row]!)
      measured(name, 'sliding', rule, Math.min(...gains), { above: 0 })
      const stopped = simulate({ ...up, integrator, stopping })
      expect(stopped.outcome.kind).toBe('at-rest')
      measured(name, 'stopped', rule, Math.abs(last(stopped.v)), { atMost: 0 })
      expect(last(stopped.s)).toBeLessThan(0)
    }
  })

  it.each(ids)('%s, naive: even the block at rest slides off', (integrator) => {
    const run = simulate({ ...still, integrator, stopping: 'naive' })
    // g (sin α − μk cos α) for 3 s, or g sin α where friction is asked about at v = 0 only.
    measured(name, 'naive', [integrator], last(run.s), { above: 5 })
  })
})

describe('4 tan α = μs (1 ± 1e-12), for an hour', () => {
  const { id: name, experiments } = hardCase('edge-of-holding')
  // [s]
  const hour = samples(3600)
  const [held, freed] = experiments.map((each) => ({ ...each, duration: hour })) as [
    Experiment,
    Experiment,
  ]

  it.each(ids)('%s: just held is held to the bit', (integrator) => {
    for (const stopping of ['located', 'clamped'] as const) {
      const run = simulate({ ...held, integrator, stopping })
      expect(run.outcome).toEqual({ kind: 'at-rest', time: 0 })
      expect(run.frames).toBe(60 * hour)
      measured(name, 'held', [integrator, stopping], largest(run.s), { atMost: 0 })
      expect(run.evaluations).toBe(1)
    }
  })

  // In less than an hour the bound of the forces' rounding is below the methods' own errors.
  const whole = it.skipIf(hour < 3600)
  whole.each(methods)('$id: not quite held slides, as far as it should', ({ id, order }) => {
    const run = simulate({ ...freed, integrator: id })
    expect(run.outcome.kind).toBe('moving')
    // g cos 30° times tan 30° less μ. Drive and press, both near 5 and 8.5 m/s², are rounded: by an ulp of 4 to 8 each, of
    // which an hour makes 1e-8 m or less.
    const a = 9.81 * Math.sqrt(0.75) * 0.5773502691896257 * 1e-12
    const off = Math.abs(last(run.s) - 0.5 * a * hour * hour)
    measured(name, 'freed', [id], off, { atMost: 0.5 * 2 * 2 ** -50 * hour * hour })
    // To the same rounded forces it is exact, but for ½ a T Δt of the first-order ones and 216 000 roundings.
    const own = order === 1 ? (0.5 * a * hour) / 60 : 0
    measured(name, 'own', [id], Math.abs(last(run.s) - exact(freed, hour).s), {
      atMost: 1.001 * own + 216_000 * 2 ** -67,
    })
  })
})

describe('5 μ = 1000, Δt = 1 s', () => {
  const { id: name, experiments } = hardCase('like-glue')
  const base = { ...experiments[0]!, stopping: 'located' } as const
  const { a, time } = braking(base)

  it.each(secondOrder)('$id, located: stops where it should', ({ id }) => {
    const run = simulate({ ...base, integrator: id })
    expect(run.outcome.kind).toBe('at-rest')
    // Some roundings of 1.4 mm and of half a millisecond.
    measured(name, 'located', [id], Math.abs(last(run.s) - exact(base, 10).s), { atMost: 1e-17 })
    expect(Math.abs(run.outcome.time - time)).toBeLessThanOrEqual(1e-17)
    expect(Math.abs(last(energyResidual(run)))).toBeLessThan(1e-12)
  })

  it.each(firstOrder)('$id, located: one step is off by ½ a t²', ({ id }) => {
    const run = simulate({ ...base, integrator: id })
    expect(run.outcome.kind).toBe('at-rest')
    const off = 0.5 * a * time * time
    // And some roundings of 1.4 mm.
    measured(name, 'euler', [id], Math.abs(last(run.s) - exact(base, 10).s), {
      atLeast: off - 1e-17,
      atMost: off + 1e-17,
    })
  })

  it.each(ids)('%s, clamped: rests within the first frame’s way', (integrator) => {
    const run = simulate({ ...base, integrator, stopping: 'clamped' })
    expect(run.outcome).toEqual({ kind: 'at-rest', time: 1 })
    measured(name, 'clamped', [integrator], Math.abs(last(run.s)), { atMost: 5 })
  })

  it.each(ids)('%s, naive: is thrown farther than it was kicked', (integrator) => {
    const run = simulate({ ...base, integrator, stopping: 'naive' })
    expect(run.outcome.kind).toBe('moving')
    // One step of friction alone changes v by a Δt: 9200 m/s.
    expect(Math.max(...run.v.map(Math.abs))).toBeGreaterThan(5)
    measured(name, 'naive', [integrator], largest(run.s), { above: 100 })
    // A step that solves for its mean speed finds no friction that agrees with it, and says so.
    if (integrator === 'implicit-midpoint') expect(run.unsolved).toBeGreaterThan(0)
  })
})

describe('6 α = 90° and α = 0', () => {
  const [wall, ball] = hardCase('vertical-wall').experiments as [Experiment, Experiment]
  const [still, sliding] = hardCase('level-ramp').experiments as [Experiment, Experiment]

  it.each(methods)('$id: a wall has no friction, and no heat', ({ id, order }) => {
    for (const stopping of ['located', 'clamped', 'naive'] as const) {
      const run = simulate({ ...wall, integrator: id, stopping })
      measured('vertical-wall', 'heat', [id, stopping], largest(run.heat), { atMost: 0 })
    }
    const run = simulate({ ...wall, integrator: id })
    const fall = simulate({ ...ball, integrator: id })
    // The ball's frames are not cut at the top: Euler is off by ½ g Δt² less there. The rest is rounding, 120 steps.
    const cut = order === 1 ? (0.5 * 9.81) / 60 / 60 : 0
    const apart = largest(run.s.map((s, row) => s - fall.s[row]!))
    measured('vertical-wall', order === 1 ? 'euler' : 'fall', [id], apart, { atMost: cut + 1e-13 })
    // Downhill from the start nothing is cut, and the bits are the ball's.
    expect(simulate({ ...having(wall, { speed: 1 }), integrator: id }).s).toEqual(
      simulate({ ...having(ball, { speed: 1 }), integrator: id }).s,
    )
  })

  it.each(ids)('%s: on the level nothing changes', (integrator) => {
    for (const stopping of ['located', 'clamped', 'naive'] as const) {
      expect(simulate({ ...still, integrator, stopping }).s.every((s) => s === 0)).toBe(true)
      const run = simulate({ ...sliding, integrator, stopping })
      const rule = [integrator, stopping]
      measured('level-ramp', 'speed', rule, largest(run.v.map((v) => v - 3)), { atMost: 0 })
      // 600 roundings of a position up to 30 m.
      measured('level-ramp', 'place', rule, Math.abs(last(run.s) - 30), { atMost: 600 * 2 ** -48 })
    }
  })
})

published('friction')
