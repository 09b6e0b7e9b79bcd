import { describe, expect, it } from 'vitest'
import { limits } from '../../src/physics/experiment.ts'
import { simulate, triesOf } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const pipe: Experiment = {
  ...{ scene: 'half-pipe', integrator: 'rk4', duration: 2 },
  // Nothing happens on the way, so that no step is cut.
  ...{ parameters: { muStatic: 0, muKinetic: 0 }, stopping: 'naive' },
  timestep: { kind: 'tolerance', tolerance: 1e-6 },
  frames: { kind: 'steady', fps: 5 },
}

describe('the tries of a run', () => {
  it('are of the run that simulate has: those that were kept follow each other and fill it', () => {
    const { begins, lengths, accepted } = triesOf(pipe)
    expect(accepted).toContain(false)
    let time = 0
    for (const [i, isKept] of accepted.entries()) {
      // Ten frames of some steps: sums of their lengths are off by less than a hundred roundings.
      expect(Math.abs(begins[i]! - time)).toBeLessThan(100 * Number.EPSILON * 2)
      if (isKept) time += lengths[i]!
    }
    expect(Math.abs(time - 2)).toBeLessThan(100 * Number.EPSILON * 2)
    // Each that is kept, and each that is not, is a whole and two halves.
    const parts = 3 * accepted.length
    expect(simulate(pipe).evaluations).toBe(4 * parts)
  })

  it('are none where every step is taken as it comes', () => {
    expect(triesOf({ ...pipe, timestep: { kind: 'variable' } }).accepted).toEqual([])
  })

  it('end where the run is given up', () => {
    const limited = limits as { toTolerance: object }
    const { toTolerance } = limited
    const whole = triesOf(pipe).accepted.length
    limited.toTolerance = {
      evaluationsAnOrder: simulate(pipe).evaluations / 4,
      evaluationsAFrame: 0,
    }
    try {
      const { length } = triesOf(pipe).accepted
      expect(length).toBeGreaterThan(whole / 2)
      expect(length).toBeLessThan(whole)
      expect(simulate(pipe).abandoned).toBe(true)
    } finally {
      limited.toTolerance = toTolerance
    }
  })
})
