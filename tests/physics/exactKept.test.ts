import { describe, expect, it } from 'vitest'
import { ExperimentError, exact, exactMotion } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const pipe = (position: number): Experiment => ({ scene: 'half-pipe', parameters: { position } })

describe('exact motions', () => {
  it('are kept, the latest eight of them', () => {
    const first = Array.from({ length: 8 }, (_, i) => exactMotion(pipe(0.1 + i / 10)))
    first.forEach((motion, i) => expect(exactMotion(pipe(0.1 + i / 10))).toBe(motion))
    exactMotion(pipe(2))
    expect(exactMotion(pipe(0.2))).toBe(first[1])
    expect(exactMotion(pipe(0.1 + 7 / 10))).toBe(first[7])
    expect(exactMotion(pipe(0.1))).not.toBe(first[0])
  })

  it('take 32 MB at most, all of them together', () => {
    gc!()
    const before = process.memoryUsage().heapUsed
    const motions = Array.from({ length: 8 }, (_, i) =>
      exactMotion({
        scene: 'half-pipe',
        parameters: { position: 1 + i / 10, muStatic: 1e-9, muKinetic: 1e-9 },
      }),
    )
    for (const motion of motions) expect(motion(1e5, { s: 0, v: 0 })).toEqual({ s: NaN, v: NaN })
    gc!()
    expect(process.memoryUsage().heapUsed - before).toBeLessThan(32e6)
  })

  it('are those of the parameters as they are parsed: one that is left out is at its default', () => {
    expect(exactMotion({ scene: 'half-pipe' })).toBe(exactMotion(pipe(1.6)))
  })

  it('are each of one scene with one set of parameters', () => {
    const at = (experiment: Experiment) => exact(experiment, 1)
    expect(at({ scene: 'ramp', parameters: { speed: 1 } })).not.toEqual(
      at({ scene: 'ramp', parameters: { speed: 2 } }),
    )
    expect(at({ scene: 'ramp', parameters: { speed: 1 } })).not.toEqual(
      at({ scene: 'fall', parameters: { speed: 1 } }),
    )
    expect(at({ scene: 'fall' })).toEqual({ s: 9.81 / 2, v: 9.81 })
  })

  it('begin at 0 s and end at no finite time', () => {
    expect(exact(pipe(1), 0)).toEqual({ s: 1, v: 0 })
    for (const [t, shown] of [
      [-1, '-1'],
      [Infinity, 'Infinity'],
      [NaN, 'NaN'],
      ['1', '"1"'],
      [1n, '1'],
      [undefined, 'undefined'],
      [[1], 'a list of 1'],
    ] as [number, string][])
      expect(() => exact(pipe(1), t)).toThrow(
        new RangeError(`The motion is known at finite times from 0 s on, not at ${shown} s.`),
      )
  })

  it('that are not known are refused with the reason', () => {
    const slow: Experiment = { scene: 'half-pipe', parameters: { muStatic: 1e-9, muKinetic: 1e-9 } }
    expect(exact(slow, 1000).s).toBeTypeOf('number')
    expect(() => exact(slow, 1e5)).toThrow(
      new RangeError('The motion is not known to 1e-11 at 100000 s.'),
    )
  })

  it('of what is no experiment are refused as it is, whatever was asked before', () => {
    expect(() => exactMotion({ scene: 'ramp', parameters: { angle: 91 } })).toThrow(
      'parameters.angle: 91 is not in 0…90',
    )
    exactMotion({ scene: 'ramp', parameters: { speed: 7 } })
    const cyclic: Record<string, unknown> = {}
    cyclic['angle'] = cyclic
    for (const value of [
      undefined,
      null,
      {},
      { scene: 'ramp', parameters: { speed: new Number(7) } },
      { scene: 'ramp', parameters: { speed: 7n } },
      { scene: 'ramp', parameters: cyclic },
    ])
      expect(() => exactMotion(value as Experiment)).toThrow(ExperimentError)
  })
})
