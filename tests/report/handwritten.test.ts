import { describe, expect, it } from 'vitest'
import { simulate } from '../../src/physics/index.ts'
import { handwritten, looping } from '../../src/report/handwritten/index.ts'
import { timed, trial } from '../../src/report/timing/trials.ts'

const ground = { gravity: 9.81, mass: 1.5 }
const stopping = {
  ramp: { ...ground, angle: 20, muStatic: 0.5, muKinetic: 0.4, position: 0, speed: -6 },
  'half-pipe': {
    ...ground,
    ...{ radius: 2, muStatic: 0.15, muKinetic: 0.12, position: 1.6, speed: 0 },
  },
  spring: {
    ...ground,
    ...{ angle: 30, stiffness: 12, muStatic: 0.25, muKinetic: 0.2, position: -2, speed: 0 },
  },
} as const

const cases = handwritten.flatMap((loop) => {
  const { scene, integrator } = loop
  const moves = trial(scene, integrator)
  const stops = { ...moves, parameters: stopping[scene as keyof typeof stopping] }
  const { muStatic } = stops.parameters
  const turns = { ...stops.parameters, muStatic: muStatic / 10, muKinetic: muStatic / 10 }
  return [
    { loop, name: 'moves', experiment: moves, outcome: 'moving' },
    { loop, name: 'stops', experiment: stops, outcome: 'at-rest' },
    {
      loop,
      name: 'turns within frames of a twentieth of a second',
      experiment: { ...stops, parameters: turns, frames: { kind: 'steady', fps: 20 } } as const,
      outcome: 'moving',
    },
  ]
})

describe('a handwritten loop does the same job as simulate', () => {
  it('in the ramp, half-pipe and spring, with Verlet and RK4', () => {
    expect(handwritten.map(({ scene, integrator }) => `${scene} ${integrator}`)).toEqual(
      ['ramp', 'half-pipe', 'spring'].flatMap((scene) => [
        `${scene} velocity-verlet`,
        `${scene} rk4`,
      ]),
    )
  })

  it.each(cases)('$loop.scene, $loop.integrator: $name', ({ loop, experiment, outcome }) => {
    const run = simulate(experiment)
    const block = loop.start(experiment.parameters)
    const { fps } = experiment.frames
    block.frames(run.frames, 1 / fps)
    const row = run.frames
    expect(run.outcome.kind).toBe(outcome)
    expect(block.slip === 0).toBe(outcome === 'at-rest')
    expect(Math.abs(block.clock.time - run.time[row]!)).toBeLessThan(1e-14 * experiment.duration)
    // Ten thousand steps, each rounded a few times, in a motion that does not magnify what they add up to.
    const size = (column: Float64Array) =>
      1e5 * Number.EPSILON * column.reduce((most, x) => Math.max(most, Math.abs(x)), 1)
    expect(Math.abs(block.s - run.s[row]!)).toBeLessThan(size(run.s))
    expect(Math.abs(block.v - run.v[row]!)).toBeLessThan(size(run.v))
    // Where the press changes, the heat is a sum of another kind, of the second order at least: (Δt/T)² of what there is.
    const heatError = fps === 20 ? 2e-3 : 1e-6
    expect(Math.abs(block.heat - run.heat[row]!)).toBeLessThan(heatError * (1 + block.heat))
  })

  it.each(handwritten.filter(({ scene }) => scene === 'half-pipe'))(
    '$integrator: the half-pipe ends at the lip',
    ({ scene, integrator, start }) => {
      const parameters = { ...stopping[scene as 'half-pipe'], position: 0, speed: 9 }
      const run = simulate({ ...trial(scene, integrator), parameters })
      const block = start(parameters)
      block.frames(timed.steps, timed.step)
      expect(run.outcome.kind).toBe('left-the-track')
      expect(block.slip).toBe(0)
      expect(block.s).toBeCloseTo(Math.PI, 12)
      expect(block.v).toBeCloseTo(run.v[run.frames]!, 11)
      // As above: the loop's sum of heat is of the second order.
      expect(Math.abs(block.heat - run.heat[run.frames]!)).toBeLessThan(1e-6 * (1 + block.heat))
      expect(block.clock.time).toBe(10)
    },
  )

  it('is timed from its start each time', () => {
    const [{ scene, integrator, start }] = handwritten as [(typeof handwritten)[0]]
    const { parameters } = trial(scene, integrator)
    const work = looping(() => start(parameters), { runs: 2, steps: 3, step: 0.1 })
    const block = start(parameters)
    block.frames(3, 0.1)
    for (let round = 0; round < 2; round++) {
      work.prepare!()
      expect(work.run()).toBe(2 * (block.s + block.v + block.heat))
    }
    expect(work.units).toBe(6)
  })
})
