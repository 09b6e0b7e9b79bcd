import { expect, it } from 'vitest'
import { exactMotion, scenes, simulate } from '../../src/physics/index.ts'
import type { Scene, State } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { fineRunOut } from './fine.ts'
import { bendsFromRest } from './generated.ts'
import { last, relative } from './truth.ts'

const cases = bendsFromRest(samples(1000), 20260107)
const ends: State[] = cases.map((each) => exactMotion(each)(each.duration!, { s: 0, v: 0 }))
const fine: State[] = cases.map(fineRunOut)
const runOut: Scene = scenes.find(({ id }) => id === 'run-out')!

/** The cases in which an error is beyond its bound, the worst first. */
function worst(errors: readonly number[], bound: number): string[] {
  return errors
    .map((error, i) => ({ error, text: `${error}: ${JSON.stringify(cases[i])}` }))
    .filter(({ error }) => !(error <= bound))
    .sort((a, b) => b.error - a.error)
    .map(({ text }) => text)
}

it('the reference agrees with a fine integration on bends from rest', () => {
  const errors = cases.map((_, i) => relative(fine[i]!.s - ends[i]!.s, ends[i]!.s))
  // The fine steps are good for 1e-9; ten times that, for what a slow start makes of it.
  const wrong = worst(errors, 1e-8)
  expect(wrong.length, wrong.slice(0, 3).join('\n')).toBe(0)
})

it('without friction the reference keeps the energy of a bend from rest', () => {
  const whole = Object.fromEntries(
    Object.entries(runOut.parameters).map(([name, { initial }]) => [name, initial]),
  )
  const errors = cases.map(({ parameters }, i) => {
    if (parameters!.muKinetic! > 0) return 0
    const given = { ...whole, ...parameters } as Record<string, number>
    const potential = (s: number) => runOut.potential(given, s)
    const { s, v } = ends[i]!
    const fallen = potential(parameters!.position!) - potential(s)
    return Math.abs(0.5 * v * v - fallen) / Math.max(1, fallen)
  })
  const wrong = worst(errors, 1e-11)
  expect(wrong.length, wrong.slice(0, 3).join('\n')).toBe(0)
})

it('rk8 in steps of 1/500 s agrees with a fine integration on bends from rest', () => {
  const errors = cases.map((each, i) => {
    const timestep = { kind: 'substeps', step: 1 / 500 } as const
    const run = simulate({ ...each, integrator: 'rk8', timestep })
    return relative(last(run.s) - fine[i]!.s, fine[i]!.s)
  })
  // In the smallest bend, R = 0.05 m, a step of rk8 is ω dt = 0.03: nothing next to the fine steps' own error.
  const wrong = worst(errors, 1e-8)
  expect(wrong.length, wrong.slice(0, 3).join('\n')).toBe(0)
})
