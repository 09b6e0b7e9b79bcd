import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  cellKinds,
  fingerprintExperiments,
  mappedExperiment,
  rateMap,
} from '../../src/measure/index.ts'
import type { MapRequest } from '../../src/measure/index.ts'
import { parseExperiment, scenes } from '../../src/physics/index.ts'
import { withParameters } from '../../src/measure/withParameters.ts'

const mu = fc.double({ min: 0, max: 2, noNaN: true })
const pair = fc
  .tuple(mu, mu)
  .map(([a, b]) => ({ muStatic: Math.max(a, b) + 0, muKinetic: Math.min(a, b) + 0 }))

describe('one of the two frictions, set anew', () => {
  it('stays as it is set; the other follows where it has to, and no further', () => {
    fc.assert(
      fc.property(pair, mu, (before, value) => {
        const lower = withParameters(before, { muStatic: value })
        expect(lower).toEqual({ muStatic: value, muKinetic: Math.min(before.muKinetic, value) })
        const higher = withParameters(before, { muKinetic: value })
        expect(higher).toEqual({ muKinetic: value, muStatic: Math.max(before.muStatic, value) })
      }),
      { seed: 1 },
    )
  })

  it('moves nothing where both are set, or neither', () => {
    const crossed = { muStatic: 0.1, muKinetic: 0.2 }
    expect(withParameters({ muStatic: 1, muKinetic: 1 }, crossed)).toEqual(crossed)
    expect(withParameters(crossed, { angle: 3 })).toEqual({ ...crossed, angle: 3 })
    expect(withParameters({ mass: 1 }, { mass: 2 })).toEqual({ mass: 2 })
  })
})

const withFriction = scenes.filter(({ parameters }) => 'muStatic' in parameters)

it.each(withFriction)('a map of $id over either friction has no row that is refused', ({ id }) => {
  for (const parameter of ['muStatic', 'muKinetic'])
    for (const parameters of [{}, { muStatic: 0.5, muKinetic: 0.4 }]) {
      const request: MapRequest = {
        experiment: { scene: id, parameters, duration: 0.5 },
        of: 'spread',
        parameter,
        from: 0,
        to: 1.5,
        slowest: 5,
        fastest: 60,
        columns: 2,
        rows: 8,
      }
      for (const { kinds } of rateMap(request))
        for (const kind of kinds) expect(cellKinds[kind]).not.toBe('refused')
      const { muStatic, muKinetic } = parseExperiment(mappedExperiment(request, 0, 6)).parameters
      expect(muStatic).toBeGreaterThanOrEqual(muKinetic!)
    }
})

it('every experiment of the fingerprint can be run', () => {
  for (const experiment of fingerprintExperiments())
    expect(() => parseExperiment(experiment)).not.toThrow()
})
