import { describe, expect, it } from 'vitest'
import { createRun, integrators, scenes, simulate } from '../../src/physics/index.ts'
import { bareLoops, inFrames, inSeconds } from '../../src/report/bare/index.ts'

const cases = bareLoops.flatMap((loop) => loop.trials.map((trial) => ({ loop, trial })))

describe('the loops written by hand', () => {
  it('are of every scene, with every method that is in the benchmark', () => {
    const measured = integrators.filter(({ id }) =>
      bareLoops.some(({ integrator }) => integrator === id),
    )
    expect(measured.length).toBeGreaterThanOrEqual(7)
    expect(bareLoops.map(({ scene, integrator }) => `${scene} ${integrator}`)).toEqual(
      scenes.flatMap((scene) => measured.map(({ id }) => `${scene.id} ${id}`)),
    )
  })

  it.each(cases)(
    '$loop.scene, $loop.integrator, $trial.kind: do the same job as simulate',
    ({ loop, trial }) => {
      const run = simulate(inFrames(trial, loop.integrator))
      const end = loop.end(trial.parameters, 1 / trial.fps, trial.steps)
      const row = run.frames
      expect(run.steps).toBe(trial.steps)
      expect(run.outcome.kind).toBe(trial.kind === 'moves' ? 'moving' : 'at-rest')
      // Ten thousand steps, each rounded a few times, in a motion that does not magnify what they add up to.
      const size = (column: Float64Array) =>
        1e5 * Number.EPSILON * column.reduce((most, x) => Math.max(most, Math.abs(x)), 1)
      expect(Math.abs(end.s - run.s[row]!)).toBeLessThan(size(run.s))
      expect(Math.abs(end.v - run.v[row]!)).toBeLessThan(size(run.v))
      // Sums of another kind where the press changes, of the second order at least: (Δt/T)² of what there is.
      expect(Math.abs(end.heat - run.heat[row]!)).toBeLessThan(1e-6 * (1 + end.heat))
      expect(loop.run(trial.parameters, 1 / trial.fps, trial.steps)).toBe(end.s + end.v + end.heat)
    },
  )

  it('are compared with the same steps, a second at a time', () => {
    for (const { loop, trial } of cases) {
      const recorded = simulate(inFrames(trial, loop.integrator))
      const run = createRun(inSeconds(trial, loop.integrator))
      for (let second = 0; second < trial.steps / trial.fps; second++) run.frame(1)
      expect(run.steps).toBe(trial.steps)
      expect([run.motion.s, run.motion.v, run.heat]).toEqual(
        [recorded.s, recorded.v, recorded.heat].map((column) => column[recorded.frames]),
      )
    }
  })
})
