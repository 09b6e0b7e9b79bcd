import { expect, it } from 'vitest'
import { simulate } from '../../src/physics/index.ts'
import { bends, last, relative } from './truth.ts'

it.each(bends)('rk8 in steps of 1/2000 s ends where a bend ends in truth: $name', (each) => {
  const run = simulate({
    ...each.experiment,
    integrator: 'rk8',
    timestep: { kind: 'substeps', step: 1 / 2000 },
  })
  // What the inputs' own rounding moves comes again with each of some thousand steps' roundings.
  const ill = 1e4 * each.condition
  expect(run.outcome.kind).toBe(each.outcome)
  expect(Math.abs(last(run.s) - each.s)).toBeLessThanOrEqual(
    1e-9 * Math.max(1, Math.abs(each.s)) + ill,
  )
  if (each.outcome === 'moving') expect(run.outcome.time).toBe(each.experiment.duration)
  else if (each.outcome === 'at-rest') {
    expect(last(run.v)).toBe(0)
    expect(relative(run.outcome.time - each.time!, each.time!)).toBeLessThanOrEqual(1e-9)
  } else
    // An error of place is one of time at the speed of leaving.
    expect(Math.abs(run.outcome.time - each.time!)).toBeLessThanOrEqual(
      1e-9 + ill / Math.abs(each.v),
    )
})
