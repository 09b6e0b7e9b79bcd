import { describe, expect, it } from 'vitest'
import { energyResidual, frameRateSpread, paperMethod } from '../../src/measure/index.ts'
import {
  exact,
  integrators,
  parseExperiment,
  simulate,
  traceFrame,
} from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { measured, published } from './measured.ts'
import { hardCase, largest, last } from './support.ts'

const controlled = ['velocity-verlet', 'rk4', 'rk8'] as const

describe('25 the tolerance asked for', () => {
  const { id: name, experiments } = hardCase('to-tolerance-in-every-scene')

  it.each(experiments)(
    '$scene: the spread is what was asked, ten times at the most',
    (experiment) => {
      const { duration } = parseExperiment(experiment)
      for (const integrator of controlled)
        for (const [claim, tolerance] of [
          ['1e-3', 1e-3],
          ['1e-6', 1e-6],
          ['1e-9', 1e-9],
        ] as const) {
          const { agree, distance } = frameRateSpread({
            ...experiment,
            integrator,
            timestep: { kind: 'tolerance', tolerance },
          })
          expect(agree).toBe(true)
          measured(name, claim, [experiment.scene, integrator], distance / (tolerance * duration), {
            atMost: 10,
          })
        }
    },
  )

  it('Runge–Kutta 8 takes a second of half-pipe in 2500 evaluations', () => {
    const pipe = experiments.find(({ scene }) => scene === 'half-pipe')!
    const run = simulate({ ...pipe, frames: { kind: 'steady', fps: 60 } })
    measured(name, 'price', [], run.evaluations / 10, { atMost: 2500 })
  })

  it('the paper’s step is far from it', () => {
    for (const experiment of experiments) {
      if (!['ramp', 'run-out', 'half-pipe', 'crest'].includes(experiment.scene)) continue
      const { agree, distance } = frameRateSpread({ ...experiment, ...paperMethod })
      if (!agree) continue
      const { duration } = parseExperiment(experiment)
      measured(name, 'paper', [experiment.scene], distance / (1e-3 * duration), { above: 10 })
    }
  })
})

describe.each([hardCase('two-reversals-below-pi'), hardCase('two-reversals-beyond-pi')])(
  '27 $label',
  ({ id: name, experiments }) => {
    const [base] = experiments as [Experiment]
    const truth = exact(base, 0.5)

    it.each(controlled)('%s to tolerance: each reversal is found', (integrator) => {
      const experiment = { ...base, integrator }
      const run = simulate(experiment)
      measured(name, 'error', [integrator], Math.abs(last(run.s) - truth.s), { atMost: 5e-7 })
      // Half a swing lasts π/ω.
      const { stiffness } = base.parameters!
      const halves = Math.floor((0.5 * Math.sqrt(stiffness!)) / Math.PI)
      // Verlet takes thousands of steps a swing, which are the same to the eye: its trace would take minutes.
      if (integrator === 'velocity-verlet') return
      let found = 0
      for (let frame = 1; frame <= run.frames; frame++)
        for (const { takenBack, stretches } of traceFrame(experiment, frame))
          if (!takenBack) found += stretches.filter(({ ends }) => ends === 'stop').length
      measured(name, 'found', [integrator], Math.abs(found - halves), { atMost: 0 })
    })

    it.each(integrators)('$id, a step a frame: goes wrong, and ends', ({ id }) => {
      const run = simulate({ ...base, integrator: id, timestep: { kind: 'variable' } })
      measured(name, 'wrong', [id], Math.abs(last(run.s) - truth.s), { atLeast: 5e-4 })
    })
  },
)

describe.each([hardCase('heat-of-drag'), hardCase('heat-of-friction')])(
  '28 $label',
  ({ id: name, experiments }) => {
    const base = experiments[0]!
    // Where the leading term is all: in the air, a step of 1/5 s is as long as the air's own time, m/(c v).
    const rk8 = base.scene === 'fall' ? 1 / 10 : 1 / 5
    const coarsest: Record<string, number> = { rk8, rk4: 1 / 20, yoshida4: 1 / 20 }

    it.each(integrators)('$id: the energy residual falls with its order', (method) => {
      const first = coarsest[method.id] ?? 1 / 40
      const errors = [1, 2, 4, 8, 16]
        .map((parts) =>
          largest(
            energyResidual(
              simulate({
                ...base,
                integrator: method.id,
                timestep: { kind: 'substeps', step: first / parts },
              }),
            ),
          ),
        )
        // Of 100 J, in some hundred steps, roundings leave less than a tenth of this.
        .filter((error) => error > 1e-12)
      expect(errors.length).toBeGreaterThanOrEqual(3)
      const order = Math.log2(errors[0]! / errors.at(-1)!) / (errors.length - 1)
      measured(name, 'order', [method.id], order - method.orderWithSpeed, { atLeast: -0.4 })
    })

    it('Runge–Kutta 8 in short steps: to rounding', () => {
      const timestep = { kind: 'substeps', step: 1 / 240 } as const
      const run = simulate({ ...base, integrator: 'rk8', timestep })
      expect(last(run.heat)).toBeGreaterThan(5)
      measured(name, 'rk8', [], largest(energyResidual(run)), { atMost: 720 * 2 ** -46 })
    })
  },
)

published('tolerances')
