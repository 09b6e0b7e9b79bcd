import { describe, expect, it } from 'vitest'
import {
  createRun,
  exact,
  exactMotion,
  frameClocks,
  integrators,
  scenes,
  simulate,
  stoppings,
  timesteps,
} from '../../src/physics/index.ts'
import type { Experiment, FramesChoice, Timestep } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { last } from './truth.ts'

const allTimesteps: Timestep[] = [
  { kind: 'per-frame', step: 1 / 60 },
  { kind: 'variable' },
  { kind: 'capped', cap: 0.05 },
  { kind: 'substeps', step: 1 / 100 },
  { kind: 'fixed', step: 1 / 60, maxSteps: 20 },
  { kind: 'tolerance', tolerance: 1e-4 },
]
const allFrames: FramesChoice[] = [
  { kind: 'steady', fps: 30 },
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 1 },
  { kind: 'hitch', fps: 60, every: 0.5, length: 0.3 },
  { kind: 'missed-vsync', fps: 60, seed: 1 },
  { kind: 'recorded', durations: [0.02, 0.05, 0.011] },
]

/** Every scene with every method and rule, the policies and clocks in turn. */
const everything: Experiment[] = scenes.flatMap(({ id: scene }) =>
  integrators.flatMap(({ id: integrator }, i) =>
    stoppings.map(({ id: stopping }, j) => ({
      scene,
      integrator,
      stopping,
      timestep: allTimesteps[(i + j) % allTimesteps.length]!,
      frames: allFrames[(i + 2 * j) % allFrames.length]!,
      duration: 2.05,
    })),
  ),
)

describe('simulate', () => {
  it('is tested with every policy and clock', () => {
    expect(allTimesteps.map(({ kind }) => kind)).toEqual(timesteps.map(({ id }) => id))
    expect(allFrames.map(({ kind }) => kind)).toEqual(frameClocks.map(({ id }) => id))
  })

  it('gives a row for every frame and one for the start, all of them numbers, the last at the end', () => {
    for (const experiment of everything) {
      const run = simulate(experiment)
      for (const column of [run.time, run.stateTime, run.s, run.v, run.drawnS, run.heat]) {
        expect(column.length).toBe(run.frames + 1)
        expect(column.every(Number.isFinite)).toBe(true)
      }
      expect(run.time[0]).toBe(0)
      if (run.outcome.kind === 'moving' || run.outcome.kind === 'at-rest')
        expect(last(run.time)).toBe(2.05)
    }
  })

  it('gives the same bits every time', () => {
    for (const experiment of everything.slice(0, samples(everything.length)))
      expect(simulate(experiment)).toEqual(simulate(experiment))
  })

  it('is a loop around createRun: the same frames by hand give the same bits', () => {
    for (const experiment of everything.filter(({ frames }) => frames?.kind === 'steady')) {
      const recorded = simulate(experiment)
      const run = createRun(experiment)
      for (let row = 1; row < recorded.frames; row++) {
        run.frame(1 / 30)
        // The hand-driven clock adds rounded durations: its time may differ by an ulp, and drawing with it.
        expect(run.motion.s).toBe(recorded.s[row])
        expect(run.motion.v).toBe(recorded.v[row])
        expect(Math.abs(run.time - recorded.time[row]!)).toBeLessThanOrEqual(Number.EPSILON * 2)
        expect(run.drawnS).toBeCloseTo(recorded.drawnS[row]!, 12)
      }
    }
  })

  it('counts: steps by the policy, evaluations by the method', () => {
    for (const { id, evaluations } of integrators) {
      const {
        steps,
        frames,
        evaluations: counted,
      } = simulate({
        scene: 'half-pipe',
        integrator: id,
        parameters: { muKinetic: 0.05, muStatic: 0.05 },
        duration: 0.5,
      })
      expect(frames).toBe(30)
      expect(steps).toBe(30)
      // No stop yet but the start, which is decided at the cost of one.
      expect(counted).toBeGreaterThanOrEqual(evaluations.least * steps)
      expect(counted).toBeLessThanOrEqual(evaluations.most * steps + 1)
    }
  })

  it('uses an acceleration again where the force ignores v', () => {
    const evaluations = (muKinetic: number) =>
      simulate({
        scene: 'half-pipe',
        parameters: { muKinetic, muStatic: muKinetic },
        duration: 0.5,
      }).evaluations
    expect(evaluations(0)).toBe(30 + 2)
    expect(evaluations(0.05)).toBe(2 * 30 + 1)
  })

  it('a run of no length is its start', () => {
    for (const { id } of scenes) {
      const run = simulate({ scene: id, duration: 0 })
      expect(run.frames).toBe(0)
      expect(run.s[0]).toBe(run.experiment.parameters.position)
      expect(run.outcome).toEqual({ kind: 'moving', time: 0 })
    }
  })

  it('cuts the last frame to end with the run', () => {
    const run = simulate({ scene: 'fall', duration: 0.25, frames: { kind: 'steady', fps: 10 } })
    expect([...run.time]).toEqual([0, 0.1, 0.2, 0.25])
    expect(last(run.s)).toBeCloseTo(0.5 * 9.81 * 0.0625, 14)
  })

  it('says when a block has left the track, and stops there', () => {
    for (const { id } of stoppings) {
      const run = simulate({
        scene: 'half-pipe',
        parameters: { position: 0, speed: 7 },
        stopping: id,
        duration: 10,
      })
      // v₀² > 2gR takes it over the lip, π/2 R up.
      expect(run.outcome.kind).toBe('left-the-track')
      expect(run.frames).toBeLessThan(600)
      expect(last(run.stateTime)).toBe(run.outcome.time)
      expect(last(run.s)).toBeGreaterThanOrEqual(Math.PI)
      if (id === 'located') expect(last(run.s)).toBe((Math.PI / 2) * 2)
    }
  })

  it('says when a step has diverged, and leaves nothing that is not a number', () => {
    // Drag pushes the ball back harder than it came, and the next time harder still.
    const run = simulate({
      scene: 'fall',
      parameters: { drag: 100, speed: 50 },
      integrator: 'explicit-euler',
      stopping: 'naive',
      duration: 5,
    })
    expect(run.outcome.kind).toBe('diverged')
    expect(run.s.every(Number.isFinite)).toBe(true)
    expect(run.v.every(Number.isFinite)).toBe(true)
  })

  it('reports implicit steps that were not solved', () => {
    // Naive friction has no solution where v̄ = 0 lies between two signs.
    const chattering = simulate({
      scene: 'ramp',
      parameters: { angle: 5, speed: 1 },
      integrator: 'implicit-midpoint',
      stopping: 'naive',
    })
    expect(chattering.unsolved).toBeGreaterThan(0)
    expect(simulate({ scene: 'ramp', integrator: 'implicit-midpoint' }).unsolved).toBe(0)
  })

  it('joints and stops inside one step are all found, in any order', () => {
    // One frame holds the end of the slope, the bend, the flat and the stop there.
    const once: Experiment = {
      scene: 'run-out',
      parameters: {
        angle: 30,
        length: 0.2,
        bendRadius: 0.05,
        muKinetic: 0.6,
        muStatic: 0.6,
        speed: 2,
      },
      integrator: 'rk4',
      frames: { kind: 'steady', fps: 1 },
      duration: 3,
    }
    const run = simulate(once)
    const truth = exact(once, 3)
    expect(run.outcome.kind).toBe('at-rest')
    expect(last(run.v)).toBe(0)
    expect(truth.v).toBe(0)
    // The two straights are exact; the bend, crossed in 0.02 s, costs rk4 some (v/R Δt)⁵ of its length.
    expect(Math.abs(last(run.s) - truth.s)).toBeLessThan(1e-3)
  })
})

describe('createRun', () => {
  it('is driven by the caller’s frames', () => {
    const game = createRun({ scene: 'ramp' })
    for (const duration of [0.01, 0.2, 0, 0.033]) game.frame(duration)
    expect(game.frames).toBe(4)
    // 0.01 + 0.2 + 0.033 of rounded numbers: to one rounding.
    expect(game.time).toBeCloseTo(0.243, 15)
    expect(game.motion.s).toBeCloseTo(exact({ scene: 'ramp' }, 0.243).s, 14)
    expect(game.outcome).toEqual({ kind: 'moving', time: game.time })
    // μk m g cos α × the way slid.
    expect(game.heat).toBeCloseTo(0.2 * 9.81 * Math.sqrt(0.75) * game.motion.s, 13)
  })

  it.each([NaN, -1, Infinity])('refuses a frame of %s s', (duration) => {
    expect(() => createRun({ scene: 'ramp' }).frame(duration)).toThrow(RangeError)
  })

  it('goes on telling the time of a run that has ended', () => {
    const game = createRun({ scene: 'half-pipe', parameters: { position: 0, speed: 20 } })
    for (let i = 0; i < 60; i++) game.frame(1 / 60)
    expect(game.ended).toBe(true)
    expect(game.time).toBe(1)
    expect(game.stateTime).toBe(game.outcome.time)
  })
})

describe('exact', () => {
  it('does not depend on frames or methods, and is kept for the next call', () => {
    const experiment: Experiment = { scene: 'half-pipe', parameters: { muKinetic: 0.1 } }
    expect(exactMotion(experiment)).toBe(
      exactMotion({ ...experiment, integrator: 'rk4', frames: { kind: 'steady', fps: 5 } }),
    )
    expect(exact(experiment, 1)).toEqual(exact({ ...experiment, duration: 5 }, 1))
  })

  it('refuses a time before the start, and a bad experiment', () => {
    expect(() => exact({ scene: 'ramp' }, -1)).toThrow(/0 s on/)
    expect(() => exact({ scene: 'ramp' }, NaN)).toThrow(RangeError)
    expect(() => exact({ scene: 'ramp', parameters: { angle: 91 } }, 1)).toThrow(/parameters.angle/)
  })
})
