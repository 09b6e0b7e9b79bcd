import { describe, expect, it } from 'vitest'
import {
  createRun,
  integrators,
  parseExperiment,
  scenes,
  simulate,
  stoppings,
} from '../../src/physics/index.ts'
import type { Experiment, Scene } from '../../src/physics/index.ts'
import { measured, published } from './measured.ts'
import { hardCase, having, largest, largestError, last, methods, secondOrder } from './support.ts'

const ids = integrators.map(({ id }) => id)
const sizes = [5e-324, 1e-310, 2.2250738585072014e-308, 1e-200, 1e-154, 1e-16, 1e6, 1e9]

describe('13 denormal and huge speeds and positions', () => {
  it.each(ids)('%s gives numbers in every scene, with every rule', (integrator) => {
    for (const scene of scenes as readonly Scene[])
      for (const { id: stopping } of stoppings)
        for (const name of ['speed', 'position'])
          for (const size of sizes)
            for (const value of [size, -size]) {
              const parameters = { [name]: value }
              const start = Object.fromEntries(
                Object.entries(scene.parameters).map(([key, { initial }]) => [key, initial]),
              )
              if (scene.conflict?.({ ...start, ...parameters })) continue
              const experiment = {
                scene: scene.id,
                parameters,
                integrator,
                stopping,
                duration: 0.5,
              }
              const run = simulate(experiment as Experiment)
              for (const column of [run.s, run.v, run.drawnS, run.heat])
                expect(column.every(Number.isFinite), JSON.stringify(experiment)).toBe(true)
              // A bend that is crossed a hundred million times in a step is not resolved; all else is.
              if (!('bendRadius' in start)) expect(run.outcome.kind).not.toBe('diverged')
            }
  })

  const [kicked, denormal, tiny] = hardCase('smallest-numbers').experiments as [
    Experiment,
    Experiment,
    Experiment,
  ]

  it.each(ids)('%s: the smallest kick there is stops at once, where it was', (integrator) => {
    const run = simulate({ ...kicked, integrator })
    expect(run.outcome.kind).toBe('at-rest')
    // The instant of a stop is known to a rounding of the frame, and the place to what a does in that time.
    const instant = Number.EPSILON / 60
    expect(run.outcome.time).toBeLessThanOrEqual(instant)
    measured('smallest-numbers', 'kick', [integrator], Math.abs(last(run.s)), {
      atMost: 10 * instant * instant,
    })
    expect(last(run.heat)).toBeLessThanOrEqual(10 * 10 * instant * instant)
  })

  it.each(ids)('%s: a swing of 1e-310 m is one of 1e-200 m, made smaller', (integrator) => {
    const small = simulate({ ...denormal, integrator })
    const large = simulate({ ...tiny, integrator })
    expect(small.frames).toBe(large.frames)
    // sin x = x there, so that all is linear, and a step rounds to 5e-324 some ten times; explicit Euler lets what it
    // has rounded grow by 1 + (ωΔt)² a step, to three times as much.
    const rounding = 600 * 10 * 5e-324 * 3
    const apart = largest(small.s.map((s, row) => s - large.s[row]! * 1e-110))
    measured('smallest-numbers', 'swing', [integrator], apart, { atMost: rounding })
  })

  it.each([1, 1e-154, 1e-190, 1e-250])(
    'a spring whose forces are of size %f is as stable',
    (size) => {
      // At ωΔt = 7, which implicit midpoint can bear, at any scale: all is linear. Twenty swings grow in nothing.
      const spring: Experiment = {
        scene: 'spring',
        parameters: { angle: 0, stiffness: 49, muStatic: 0, muKinetic: 0, position: size },
        integrator: 'implicit-midpoint',
        frames: { kind: 'steady', fps: 1 },
        duration: 60,
      }
      const run = simulate(spring)
      expect(run.outcome.kind).toBe('moving')
      expect(run.unsolved).toBe(0)
      expect(Math.max(...run.s.map(Math.abs))).toBeLessThanOrEqual(
        size * (1 + 60 * 16 * Number.EPSILON),
      )
    },
  )

  it.each([
    { stiffness: 3e-323, mass: 6e4, gravity: 0 },
    { stiffness: 1, mass: 0.01, gravity: 1e-250, position: 0 },
    { stiffness: 40, mass: 1, gravity: 9.81, position: 0.122625 },
  ])('a spring with next to no force or energy has not diverged: %o', (parameters) => {
    // No stiffness to speak of, no speed whose square is a number, and a start at the very point of balance.
    const spring: Experiment = {
      scene: 'spring',
      parameters: { muKinetic: 0, muStatic: 0, ...parameters },
    }
    for (const { id } of methods.filter(({ stability }) => stability > 0))
      for (const speed of [0, 1e-200, 4])
        expect(simulate({ ...having(spring, { speed }), integrator: id }).outcome.kind).not.toBe(
          'diverged',
        )
  })

  it('a run of no more than the smallest time makes no heat that is not a number', () => {
    // Ten such units of time: the instant of the stop inside them is 0.
    const run = simulate({
      scene: 'half-pipe',
      parameters: {
        radius: 1.390883,
        muKinetic: 0.5,
        muStatic: 0.5,
        position: 1e-108,
        speed: -5e-324,
      },
      integrator: 'rk4',
      duration: 4.4e-323,
    })
    expect(run.heat.every((heat) => heat === 0)).toBe(true)
  })

  it('air so thick that a step would throw the ball back lets it sink', () => {
    // The terminal speed, √(g m/c), is reached within a ten-thousandth of a second; a step lasts 1/60 s.
    const terminal = Math.sqrt(9.81e-9)
    for (const integrator of ['velocity-verlet', 'midpoint', 'rk4'] as const) {
      const run = simulate({ scene: 'fall', parameters: { mass: 1e-9, drag: 1 }, integrator })
      expect(run.outcome.kind, integrator).toBe('moving')
      // No part of a step takes the ball back, and none makes it faster than a part's own size allows.
      const sunk = run.s.subarray(1).map((s, i) => s - run.s[i]!)
      expect(sunk.every((way) => way > 0 && way < (5 * terminal) / 60)).toBe(true)
    }
  })

  it('a step with more reversals than it may have parts is given up, and called diverged', () => {
    // Some 60 000 reversals in a frame of a second, none of which friction ends: implicit midpoint keeps the energy in
    // steps of any length. Most methods lose or gain so much in steps of a quarter swing that they rest or are lost first.
    const omega = Math.sqrt(3.6e10)
    const run = simulate({
      scene: 'spring',
      parameters: { angle: 0, stiffness: omega ** 2, position: 1, muStatic: 1e-9, muKinetic: 1e-9 },
      integrator: 'implicit-midpoint',
      frames: { kind: 'steady', fps: 1 },
      duration: 2,
    })
    expect(run.outcome.kind).toBe('diverged')
    expect(run.frames).toBe(1)
    expect(largest(run.s)).toBeLessThanOrEqual(1)
    // Of ten thousand parts none is longer than a quarter swing, ½π/ω.
    expect(run.outcome.time).toBeLessThan((10_000 * Math.PI) / 2 / omega)
    // Each takes one evaluation at the least, and what the bound on work reckons with at the most: nine tries of six.
    expect(run.evaluations).toBeGreaterThan(10_000)
    expect(run.evaluations).toBeLessThan(10_000 * 9 * 6)
  })

  it.each(secondOrder)('$id: at 1e9 m and 1e9 m/s it is off by ulps', ({ id }) => {
    const { id: name, experiments } = hardCase('largest-numbers')
    for (const experiment of experiments) {
      const run = simulate({ ...experiment, integrator: id })
      expect(run.frames).toBe(120)
      // An ulp of up to 2e9 m, 2⁻²¹ m, for each of a step's few sums.
      measured(name, 'error', [id], largestError(run), { atMost: 120 * 2 ** -21 })
    }
  })
})

describe('16 zero gravity, zero mass, zero duration', () => {
  it.each(ids)('%s: without gravity a straight changes no speed', (integrator) => {
    const { id: name, experiments } = hardCase('zero-gravity')
    const [still, moving] = experiments as [Experiment, Experiment]
    for (const { id: stopping } of stoppings) {
      expect(simulate({ ...still, integrator, stopping }).s.every((s) => s === 0)).toBe(true)
      for (const scene of ['fall', 'ramp'] as const) {
        const run = simulate({ ...moving, scene, integrator, stopping })
        expect(run.outcome.kind).toBe('moving')
        const each = [integrator, scene, stopping]
        measured(name, 'speed', each, largest(run.v.map((v) => v - 2)), { atMost: 0 })
        expect(last(run.heat)).toBe(0)
        const off = Math.abs(last(run.s) - 4)
        measured(name, 'place', each, off, { atMost: 120 * 4 * Number.EPSILON })
      }
    }
  })

  it('without gravity or mass to speak of, every scene still gives numbers', () => {
    for (const scene of scenes as readonly Scene[])
      for (const integrator of ids)
        for (const parameters of [
          { gravity: 0 },
          { mass: 1e-9 },
          { gravity: 0, mass: 1e9, speed: 1 },
        ]) {
          const run = simulate({ scene: scene.id, parameters, integrator } as Experiment)
          expect(run.s.every(Number.isFinite)).toBe(true)
        }
  })

  it('no mass is refused, with its range', () => {
    const { id: name, experiments, refused } = hardCase('zero-mass')
    expect(refused).toBe(true)
    const messages = experiments.map((experiment) => {
      try {
        parseExperiment(experiment)
        return 'not refused'
      } catch (error) {
        return (error as Error).message
      }
    })
    const right = messages.filter(
      (message) => message === 'parameters.mass: 0 is not in 1e-9…1000000000',
    )
    measured(name, 'refused', [], right.length, { atLeast: 1, atMost: 1 })
  })

  it('no duration is the start and nothing else', () => {
    const { id: name, experiments } = hardCase('zero-duration')
    const [experiment] = experiments as [Experiment]
    for (const scene of scenes)
      for (const { id: integrator } of integrators) {
        const run = simulate({ ...experiment, scene: scene.id, integrator })
        const each = [integrator, scene.id]
        measured(name, 'rows', each, run.time.length, { atLeast: 1, atMost: 1 })
        measured(name, 'work', each, run.steps + run.evaluations, { atMost: 0 })
        expect([run.frames, run.time[0], run.lostTime]).toEqual([0, 0, 0])
        expect(run.outcome).toEqual({ kind: 'moving', time: 0 })
      }
  })

  it('a frame of no length changes nothing', () => {
    const run = createRun({ scene: 'ramp', parameters: { speed: 1 } })
    for (let i = 0; i < 10; i++) run.frame(0)
    expect([run.motion.s, run.motion.v, run.time, run.stateTime]).toEqual([0, 1, 0, 0])
  })
})

published('extremes')
