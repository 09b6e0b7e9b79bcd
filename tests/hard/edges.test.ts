import { describe, expect, it } from 'vitest'
import { exact, exactMotion, scenes, simulate } from '../../src/physics/index.ts'
import type { Experiment, Scene } from '../../src/physics/index.ts'
import { bendsFromRest } from '../physics/generated.ts'
import { samples } from '../samples.ts'
import { measured, published } from './measured.ts'
import { hardCase, having, last, secondOrder } from './support.ts'

const ULP = Number.EPSILON

describe('18 a step longer than the feature', () => {
  const { id: name, experiments } = hardCase('bend-shorter-than-a-step')
  const muTheta = 0.39 * ((5.5 * Math.PI) / 180)
  const cases = [0.01, 0.03, 0.1, 0.3].flatMap((bendRadius) =>
    [0.25, 0.5, 1, 2].map((length): [string[], Experiment] => [
      [`radius ${bendRadius} m`, `hitch ${length} s`],
      {
        ...having(experiments[0]!, { bendRadius }),
        frames: { kind: 'hitch', fps: 60, every: 0.7, length },
      },
    ]),
  )

  it.each(secondOrder)('$id, located: comes out of the bend where the block does', ({ id }) => {
    for (const [words, experiment] of cases) {
      const truth = exact(experiment, experiment.duration!).s
      const run = simulate({ ...experiment, integrator: id })
      expect(run.outcome.kind).toBe('at-rest')
      const off = Math.abs(last(run.s) - truth)
      // One step holds the bend: a third of (μθ)³ of the speed, which goes into the distance squared.
      measured(name, 'located', [id, ...words], off, { atMost: ((2 * muTheta ** 3) / 3) * 17.73 })
      // 240 frames, four roundings each, of 17 m.
      if (id === 'rk8') measured(name, 'rk8', words, off, { atMost: 1000 * 16 * ULP })
    }
  })

  it.each(secondOrder)('$id, clamped: steps over the bend', ({ id }) => {
    for (const [words, experiment] of cases) {
      const truth = exact(experiment, experiment.duration!).s
      const run = simulate({ ...experiment, integrator: id, stopping: 'clamped' })
      // The bend would take μθ of the speed: of the way on the flat, v²/(2 μ g), it takes e^(−2μθ).
      const missed = 10.6 * (Math.exp(2 * muTheta) - 1)
      measured(name, 'clamped', [id, ...words], last(run.s) - truth, { atLeast: missed })
    }
  })
})

describe('19 grazing', () => {
  const lip = Math.PI

  it('the lip, by a billionth: one leaves and one stays', () => {
    const { id: name, experiments } = hardCase('lip-by-a-billionth')
    const [over, under] = experiments as [Experiment, Experiment]
    const left = simulate(over)
    expect(left.outcome.kind).toBe('left-the-track')
    measured(name, 'over', [], Math.abs(last(left.s) - lip), { atMost: 0 })
    const stays = simulate(under)
    expect(stays.outcome.kind).toBe('moving')
    const off = Math.abs(last(stays.s) - exact(under, 6).s)
    measured(name, 'under', [], off, { atMost: 6000 * 4 * ULP })
    const euler = simulate({
      ...under,
      integrator: 'explicit-euler',
      timestep: { kind: 'variable' },
    })
    expect(euler.outcome.kind).toBe('left-the-track')
    measured(name, 'euler', ['explicit-euler'], euler.outcome.time, { atMost: 0.84 })
  })

  it.each(secondOrder)('$id: over the lip and back in one step', ({ id }) => {
    const { id: name, experiments } = hardCase('over-and-back-in-a-step')
    const base = experiments[0]!
    const run = simulate({ ...base, integrator: id })
    expect(run.outcome.kind).toBe('left-the-track')
    expect(last(run.s)).toBe(lip)
    // When the reference is there.
    let [before, after] = [0, 0.2]
    while (after - before > 1e-15) {
      const middle = 0.5 * (before + after)
      if (middle === before || middle === after) break
      if (exact(base, middle).s >= lip) after = middle
      else before = middle
    }
    const { position, speed } = base.parameters!
    const turning = (9.81 * Math.cos(position! / 2) * speed!) / 2
    const bound = (after ** 3 * turning) / 6 / 0.504
    // And the bisection's own ulps, at an s of 3 m.
    const off = Math.abs(run.outcome.time - after)
    measured(name, 'located', [id], off, { atMost: bound + 4 * ULP })
    const clamped = simulate({ ...base, integrator: id, stopping: 'clamped' })
    expect(clamped.outcome.kind).toBe('moving')
    measured(name, 'clamped', [id], clamped.outcome.time, { atLeast: 1, atMost: 1 })
  })

  it('a hilltop, by a billionth: one goes over and one comes back', () => {
    const { id: name, experiments } = hardCase('top-by-a-billionth')
    const [over, under] = experiments as [Experiment, Experiment]
    const top = 3 * ((20 * Math.PI) / 180)
    for (const [claim, experiment, sign] of [
      ['over', over, 1],
      ['under', under, -1],
    ] as const) {
      const run = simulate(experiment)
      const { s, v } = exact(experiment, experiment.duration!)
      expect(Math.sign(last(run.s) - top)).toBe(sign)
      expect(Math.sign(s - top)).toBe(sign)
      // 14 000 steps round the energy by an ulp: 3e-3 of the excess. So much of 1/ω = 0.55 s later, at up to |v|.
      const bound = ((14_000 * ULP) / 1e-9) * Math.sqrt(3 / 9.81) * Math.abs(v)
      measured(name, claim, [], Math.abs(last(run.s) - s), { atMost: bound })
    }
    const euler = simulate({
      ...over,
      integrator: 'semi-implicit-euler',
      timestep: { kind: 'variable' },
    })
    const short = top - Math.max(...euler.s)
    const a = 9.81 * Math.sin((20 * Math.PI) / 180)
    const speed = over.parameters!.speed!
    const behind = (0.5 * (speed - Math.sqrt(speed * speed - 4 * a))) / 60
    // ½ g x²/R = a × that.
    measured(name, 'euler', ['semi-implicit-euler'], short, {
      atLeast: Math.sqrt((2 * a * behind * 3) / 9.81),
    })
    expect(last(euler.s)).toBeLessThan(0)
  })
})

describe('20 the reference on bends from rest', () => {
  const { id: name, experiments } = hardCase('bends-from-rest')
  const runOut: Scene = scenes.find(({ id }) => id === 'run-out')!
  const whole = Object.fromEntries(
    Object.entries(runOut.parameters).map(([key, { initial }]) => [key, initial]),
  )
  const cases = [...experiments, ...bendsFromRest(samples(1000), 20260214)]

  it('agrees with itself, with the energy, and with Runge–Kutta 8', () => {
    for (const experiment of cases) {
      const words = [`${experiment.parameters!.angle}°`]
      const duration = experiment.duration!
      const parameters = { ...whole, ...experiment.parameters } as Record<string, number>
      const motion = exactMotion(experiment)
      const end = motion(duration, { s: 0, v: 0 })
      const path = Math.max(1, Math.abs(end.s))
      // From a middle that is no multiple of anything.
      const middle = 0.37 * duration
      const { s, v } = motion(middle, { s: 0, v: 0 })
      const again = exact(having(experiment, { position: s, speed: v }), duration - middle)
      measured(name, 'itself', words, Math.abs(again.s - end.s) / path, { atMost: 2e-11 })
      const potential = (at: number) => runOut.potential(parameters, at)
      const fallen = potential(parameters.position!) - potential(end.s)
      if (parameters.muKinetic === 0)
        measured(
          name,
          'energy',
          words,
          Math.abs(0.5 * end.v * end.v - fallen) / Math.max(1, fallen),
          {
            atMost: 1e-11,
          },
        )
      const timestep = { kind: 'substeps', step: 0.002 } as const
      const run = simulate({ ...experiment, integrator: 'rk8', timestep })
      measured(name, 'rk8', words, Math.abs(last(run.s) - end.s) / path, { atMost: 1e-10 })
    }
  })
})

published('edges')
