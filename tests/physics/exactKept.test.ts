import { describe, expect, it } from 'vitest'
import { exact, exactMotion } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const pipe = (position: number): Experiment => ({ scene: 'half-pipe', parameters: { position } })

describe('exact motions', () => {
  it('are kept, the latest sixteen of them', () => {
    const first = Array.from({ length: 16 }, (_, i) => exactMotion(pipe(0.1 + i / 10)))
    first.forEach((motion, i) => expect(exactMotion(pipe(0.1 + i / 10))).toBe(motion))
    exactMotion(pipe(2))
    expect(exactMotion(pipe(0.2))).toBe(first[1])
    expect(exactMotion(pipe(1.6))).toBe(first[15])
    expect(exactMotion(pipe(0.1))).not.toBe(first[0])
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

  it('begin at 0 s, and say so to whoever asks for earlier', () => {
    expect(exact(pipe(1), 0)).toEqual({ s: 1, v: 0 })
    expect(() => exact(pipe(1), -1)).toThrow('The motion is known from 0 s on, not at -1 s.')
  })

  it('of what is no experiment are refused as it is', () => {
    expect(() => exactMotion({ scene: 'ramp', parameters: { angle: 91 } })).toThrow(
      'parameters.angle: 91 is not in 0…90',
    )
  })
})
