import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { mechanicalEnergy } from '../../src/measure/index.ts'
import {
  createRun,
  frameClocks,
  integrators,
  scenes,
  simulate,
  stoppings,
  timesteps,
} from '../../src/physics/index.ts'
import type { FramesChoice, ResolvedExperiment, Trajectory } from '../../src/physics/index.ts'
import { energyErrorOfStep, heights, lawOf, methodOf, sceneOf } from './energyBound.ts'
import { choice, experiments, tame, work } from './experiments.ts'
import { check } from './runs.ts'

const columns = ['time', 'stateTime', 's', 'v', 'drawnS', 'heat'] as const
const last = (values: Float64Array) => values[values.length - 1]!
const located = stoppings.filter(({ id }) => id === 'located')
const variable = timesteps.filter(({ id }) => id === 'variable')
const fixed = timesteps.filter(({ id }) => id === 'fixed')
const clocks = choice(frameClocks, tame) as fc.Arbitrary<FramesChoice>
/** [s] */
const durations = fc.array(
  fc.integer({ min: 1, max: 200 }).map((ms) => ms / 1000),
  { minLength: 1, maxLength: 60 },
)
describe('any experiment at all', () => {
  it('gives numbers, ever later times, heat that never falls, and counters that add up', () => {
    check(0.4, experiments('wild'), (experiment) => {
      const run = simulate(experiment)
      for (const name of columns) {
        expect(run[name].length).toBe(run.frames + 1)
        expect(run[name].every(Number.isFinite), name).toBe(true)
      }
      for (const name of ['time', 'gameTime', 'stateTime', 'heat'] as const)
        expect(rises(run[name]), name).toBe(true)
      expectCounters(run)
      expectOutcome(run)
    })
  })
})

const same = (one: Float64Array, other: Float64Array) =>
  one.length === other.length && one.every((value, row) => value === other[row])

const rises = (values: Float64Array) =>
  values.every((value, row) => row === 0 || value >= values[row - 1]!)

function expectCounters(run: Trajectory): void {
  const { experiment, frames, steps, evaluations, lostTime } = run
  const { timestep } = experiment
  const asked = work(experiment)
  // Clocks say how many frames there are but for chance: six standard deviations of as many draws, and a handful.
  const byChance = 6 * Math.sqrt(asked.frames) + 20
  expect(frames).toBeLessThanOrEqual(asked.frames + byChance)
  const perFrame = 'maxSteps' in timestep ? timestep.maxSteps : 1
  // How many steps a tolerance asks for, nobody can say before.
  if (timestep.kind !== 'tolerance')
    expect(steps).toBeLessThanOrEqual(asked.steps + byChance * perFrame + 1)
  if (timestep.kind === 'per-frame' || timestep.kind === 'variable' || timestep.kind === 'capped')
    expect(steps).toBe(frames)
  if (timestep.kind === 'variable')
    expect(same(run.stateTime.subarray(0, -1), run.gameTime.subarray(0, -1))).toBe(true)
  // A step looks at the forces at least as often as its method says, unless there is nothing to step: a block that rides
  // on a belt is asked once whether it stays.
  const { least } = methodOf(experiment.integrator).evaluations
  const once = experiment.scene === 'belt' ? 1 : least
  // So has a frame that the game takes for no time at all, and half of the smallest number is 0, which is no step to try.
  const waits = run.gameTime.some((time, row) => row > 0 && time === run.gameTime[row - 1])
  if (run.outcome.kind === 'moving' && !waits && last(run.gameTime) > Number.MIN_VALUE)
    expect(evaluations).toBeGreaterThanOrEqual(once * steps)
  // No time is lost silently. Whole steps of `fixed` may still be due, and `per-frame` goes by no clock.
  if (timestep.kind === 'per-frame') expect(lostTime).toBe(0)
  else if (run.outcome.kind === 'moving' || run.outcome.kind === 'at-rest') {
    const due = timestep.kind === 'fixed' ? timestep.step : 0
    const behind = last(run.gameTime) - last(run.stateTime) - lostTime
    // Two roundings of the time, and one of a step counted that often.
    const rounding = 8 * Number.EPSILON * last(run.gameTime)
    expect(behind).toBeGreaterThanOrEqual(-rounding)
    expect(behind).toBeLessThanOrEqual(due + rounding)
  }
}

function expectOutcome(run: Trajectory): void {
  const { outcome, experiment } = run
  expect(outcome.time).toBeGreaterThanOrEqual(0)
  // The instant is a sum of the step's start and a part of it: one rounding more than the step's end.
  expect(outcome.time).toBeLessThanOrEqual(last(run.stateTime) * (1 + 2 * Number.EPSILON))
  if (outcome.kind === 'moving' || outcome.kind === 'at-rest')
    expect(last(run.time)).toBe(experiment.duration)
  if (outcome.kind !== 'at-rest') return
  expect(last(run.v)).toBe(0)
  const end = last(run.s)
  expect(run.s.every((s, row) => s === end || run.stateTime[row]! <= outcome.time)).toBe(true)
}

describe('energy', () => {
  it('never rises beyond the order of the method, in steps that resolve the motion', () => {
    const drawn = experiments('tame', { stoppings: located, timesteps: variable })
    check(0.2, drawn, (experiment) => {
      const run = simulate(experiment)
      // A belt gives energy, but no more than its work.
      const energy = mechanicalEnergy(run).map((value, row) => value - run.work[row]!)
      const { mass = 1 } = experiment.parameters
      let excess = 0
      for (let row = 1; row <= run.frames; row++) {
        const dt = run.time[row]! - run.time[row - 1]!
        const allowed = energyErrorOfStep(run, row, dt)
        if (allowed === undefined) continue
        // Some roundings of both energies: of the speed's square and of the height.
        const size =
          Math.abs(energy[row]!) + Math.abs(energy[row - 1]!) + 2 * Math.abs(run.work[row]!)
        const rounding = 16 * Number.EPSILON * (size + mass * heights(run, row))
        excess = Math.max(excess, energy[row]! - energy[row - 1]! - mass * allowed - rounding)
      }
      expect(excess).toBeLessThanOrEqual(0)
    })
  })
})

describe('rest', () => {
  const resting = stoppings.filter(({ holdsSlip }) => holdsSlip)

  it('under tan α ≤ μs is for ever, to the last bit, whatever the frames, the policy and the method', () => {
    check(0.1, experiments('tame', { stoppings: resting }), (drawn) => {
      const scene = sceneOf(drawn.scene)
      if (scene.id === 'fall') return
      const held: Record<string, number> = { ...drawn.parameters, speed: 0, muStatic: 0 }
      if (scene.id === 'belt') held.beltSpeed = 0
      const { gravity, stiffness = 0, mass, position } = held
      const { slope } = scene.place(held, position!)
      const drive = gravity! * Math.sin(slope) - (stiffness / mass!) * position!
      const press = gravity! * Math.cos(slope)
      // A few roundings more than what just holds it; near a wall the press is what cancelling leaves of gravity.
      const rounding = 1e-12 + (8 * Number.EPSILON * gravity!) / press
      held.muStatic = (Math.abs(drive) / press) * (1 + rounding)
      if (!(held.muStatic <= 1e6)) return
      held.muKinetic = Math.min(held.muKinetic!, held.muStatic)
      const run = simulate({ ...drawn, parameters: held })
      expect(run.outcome.kind).toBe(run.frames > 0 && run.steps > 0 ? 'at-rest' : 'moving')
      expect(run.outcome.time).toBe(0)
      expect(run.s.every((s) => s === position)).toBe(true)
      expect(run.drawnS.every((s) => s === position)).toBe(true)
      expect(run.v.every((v) => v === 0)).toBe(true)
      expect(run.heat.every((heat) => heat === 0)).toBe(true)
      // Asked once, or by a try and its first half.
      expect(run.evaluations).toBeLessThanOrEqual(drawn.timestep.kind === 'tolerance' ? 2 : 1)
    })
  })
})

describe('frames', () => {
  const second = integrators.filter(({ order }) => order >= 2)
  const fall = scenes.filter(({ id }) => id === 'fall')
  const ramp = scenes.filter(({ id }) => id === 'ramp')

  it('change nothing on a fall without drag and on a ramp, for located stops and methods of second order', () => {
    const drawn = experiments('tame', {
      scenes: [...fall, ...ramp],
      integrators: second,
      stoppings: located,
      timesteps: variable,
    })
    check(0.1, fc.tuple(drawn, clocks), ([experiment, frames]) => {
      const parameters = { ...experiment.parameters }
      if (experiment.scene === 'fall') parameters.drag = 0
      const { gravity, position, speed } = parameters as Record<string, number>
      const one = simulate({ ...experiment, parameters })
      const other = simulate({ ...experiment, parameters, frames })
      // How far it might have gone: what rounding is relative to.
      const T = experiment.duration
      const scale = Math.max(1, Math.abs(position!) + Math.abs(speed!) * T + gravity! * T * T)
      expect(Math.abs(last(one.s) - last(other.s))).toBeLessThanOrEqual(1e-12 * scale)
    })
  })

  it('change no bit of the physics under `fixed` steps: a hitch shows the same states, later', () => {
    const drawn = experiments('tame', { timesteps: fixed })
    check(0.1, fc.tuple(drawn, clocks), ([experiment, frames]) => {
      // As many steps a frame as it takes: a bound would drop some.
      const timestep = {
        ...experiment.timestep,
        maxSteps: 100_000,
        cap: 60,
      } as ResolvedExperiment['timestep']
      const one = simulate({ ...experiment, timestep })
      const other = simulate({ ...experiment, timestep, frames })
      // A block that has left the track leaves the rest of its frame's steps undone.
      if (one.outcome.kind === 'moving' || one.outcome.kind === 'at-rest') {
        expect(other.steps).toBe(one.steps)
        expect(other.evaluations).toBe(one.evaluations)
        expect(last(other.stateTime)).toBe(last(one.stateTime))
      }
      expect(other.outcome).toEqual(one.outcome)
      for (const name of ['s', 'v', 'heat'] as const)
        expect(last(other[name])).toBe(last(one[name]))
      const states = new Map(Array.from(one.stateTime, (time, row) => [time, one.s[row]]))
      for (const [row, time] of other.stateTime.entries())
        if (states.has(time)) expect(other.s[row]).toBe(states.get(time))
    })
  })
})

describe('symmetries', () => {
  it('mirror images give mirrored bits', () => {
    // A hill's image is another hill, with its foot elsewhere: tests/physics/mirror.test.ts.
    const mirrored = scenes.filter(({ id }) => id !== 'run-out' && id !== 'crest')
    check(0.05, experiments('tame', { scenes: mirrored }), (experiment) => {
      const { scene, parameters } = experiment
      // What has a mirror image: no gravity along the track but the pipe's.
      const flat: Record<string, number> = {
        ...parameters,
        ...(scene === 'fall' && { gravity: 0 }),
        ...('angle' in parameters && { angle: 0 }),
      }
      const { beltSpeed = 0 } = flat
      const image = {
        ...{ ...flat, position: -flat.position!, speed: -flat.speed! },
        ...(scene === 'belt' && { beltSpeed: -beltSpeed }),
      }
      const one = simulate({ ...experiment, parameters: flat })
      const other = simulate({ ...experiment, parameters: image })
      for (const name of ['time', 'stateTime', 'heat'] as const)
        expect(same(other[name], one[name])).toBe(true)
      for (const name of ['s', 'v', 'drawnS'] as const)
        expect(one[name].every((value, row) => value === -other[name][row]!)).toBe(true)
      expect(other.outcome).toEqual(one.outcome)
      expect([other.steps, other.evaluations, other.unsolved, other.lostTime]).toEqual([
        one.steps,
        one.evaluations,
        one.unsolved,
        one.lostTime,
      ])
    })
  })

  const holding = stoppings.filter(({ holdsSlip }) => holdsSlip)

  it('a run that starts from a state of another goes on like it, to the bit', () => {
    const drawn = fc.tuple(experiments('tame', { stoppings: holding }), durations, fc.nat())
    check(0.025, drawn, ([{ scene, parameters, integrator, stopping }, frames, pick]) => {
      const whole = createRun({ scene, parameters, integrator, stopping })
      const shift = pick % frames.length
      for (const frame of frames.slice(0, shift)) whole.frame(frame)
      const { s: position, v: speed } = whole.motion
      // Off the track, and beyond what a start may be, there is nowhere to go on from.
      if (whole.ended || Math.abs(position) > 1e9 || Math.abs(speed) > 1e9) return
      const rest = createRun({
        scene,
        parameters: { ...parameters, position, speed },
        integrator,
        stopping,
      })
      for (const frame of frames.slice(shift)) {
        whole.frame(frame)
        rest.frame(frame)
      }
      // The bound beyond which a run has diverged is taken from its start.
      if (whole.outcome.kind === 'diverged' || rest.outcome.kind === 'diverged') return
      expect(rest.motion.s).toBe(whole.motion.s)
      expect(rest.motion.v).toBe(whole.motion.v)
      expect(rest.outcome.kind).toBe(whole.outcome.kind)
    })
  })

  it('a frame cut in two at the instant of a stop ends in the same place', () => {
    const drawn = fc.tuple(experiments('tame', { stoppings: located }), durations)
    check(0.025, drawn, ([{ scene, parameters, integrator }, frames]) => {
      const run = createRun({ scene, parameters, integrator })
      let stopsIn = 0
      let fastest = 0
      while (stopsIn < frames.length && run.outcome.kind === 'moving') {
        fastest = Math.max(fastest, Math.abs(run.motion.v))
        run.frame(frames[stopsIn++]!)
      }
      if (run.outcome.kind !== 'at-rest' || run.outcome.time === 0) return
      // A step that does not resolve the motion finds one of several jumps or another, by its length.
      if (lawOf(parameters).rate(fastest) * Math.max(...frames) > 0.5) return
      const cut = createRun({ scene, parameters, integrator })
      for (const frame of frames.slice(0, stopsIn - 1)) cut.frame(frame)
      const first = Math.min(frames[stopsIn - 1]!, Math.max(0, run.outcome.time - cut.time))
      cut.frame(first)
      cut.frame(frames[stopsIn - 1]! - first)
      // The instant is known to some ulps of a time of seconds, and moves the block by that times what is left of its
      // speed: with a hundred times as much for what several stops in the frame add to it.
      const { s } = run.motion
      expect(Math.abs(cut.motion.s - s)).toBeLessThanOrEqual(1e-13 * Math.max(1, Math.abs(s)))
      // Where friction fades with the speed, as without gravity in the pipe, what rounding leaves of it goes on.
      expect(Math.abs(cut.motion.v)).toBeLessThanOrEqual(1e-13)
    })
  })
})
