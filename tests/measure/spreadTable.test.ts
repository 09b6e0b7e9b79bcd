import { expect, test } from 'vitest'
import {
  frameRateSpread,
  paperMethod,
  spreadMethods,
  spreadTable,
} from '../../src/measure/index.ts'
import { integrators } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const experiments: Experiment[] = [{ scene: 'ramp' }, { scene: 'fall', duration: 1 }]

test('the paper’s own step is at the top, and each number is a spread as measured alone', () => {
  const methods = spreadMethods({ stopping: 'located', timestep: { kind: 'variable' } })
  expect(methods[0]).toEqual({
    integrator: 'semi-implicit-euler',
    stopping: 'naive',
    timestep: { kind: 'variable' },
  })
  expect(methods[0]).toBe(paperMethod)
  expect(methods).toHaveLength(integrators.length + 1)
  const parts = [...spreadTable({ methods, experiments })]
  expect(parts).toHaveLength(methods.length * experiments.length)
  const rows = parts.filter((part) => part !== undefined)
  expect(rows.map(({ row }) => row)).toEqual(methods.map((_, i) => i))
  for (const { row, spreads } of rows)
    expect([...spreads]).toEqual(
      experiments.map((each) => frameRateSpread({ ...each, ...methods[row] } as Experiment)),
    )
  // ½aTΔt at 5 fps and more; a method of the second order on a straight track has none.
  expect(rows[0]!.spreads[0]!.distance).toBeGreaterThan(0.6)
  const verlet = methods.findIndex(({ integrator }) => integrator === 'velocity-verlet')
  expect(rows[verlet]!.spreads[0]!.distance).toBeLessThan(1e-12)
})
