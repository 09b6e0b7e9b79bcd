/** Runs whose work nobody could forecast end as diverged, before they take hours. */
import { describe, expect, it } from 'vitest'
import { limits } from '../../src/physics/experiment.ts'
import { simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

describe('a run is given up', () => {
  it('in a step that holds more than ten thousand parts', () => {
    // ω = 1e5/s: 31 831 half-swings in a second, each of which ends a part.
    const parameters = { angle: 0, stiffness: 1e10, muStatic: 1e-9, muKinetic: 1e-9, position: 1 }
    const run = simulate({
      ...{ scene: 'spring', parameters, integrator: 'rk8', stopping: 'located' },
      ...{ frames: { kind: 'steady', fps: 1 }, duration: 2 },
    })
    expect(run.outcome.kind).toBe('diverged')
    expect(run.outcome.time).toBeLessThan(1)
    expect(run.frames).toBe(1)
  })

  it('in the first frame after as many evaluations as are allowed', () => {
    const limited = limits as { toTolerance: object }
    const { toTolerance } = limited
    const experiment: Experiment = {
      ...{ scene: 'half-pipe', integrator: 'velocity-verlet', duration: 10 },
      timestep: { kind: 'tolerance', tolerance: 1e-9 },
    }
    const whole = simulate({ ...experiment, duration: 1 })
    limited.toTolerance = { evaluationsAnOrder: whole.evaluations / 2, evaluationsAFrame: 0 }
    try {
      const run = simulate(experiment)
      expect(run.outcome.kind).toBe('diverged')
      // A second’s swing is as dear as the next: two seconds would be too much.
      expect(run.outcome.time).toBeGreaterThan(1)
      expect(run.outcome.time).toBeLessThan(1.2)
      expect(run.s.slice(0, 61)).toEqual(whole.s)
    } finally {
      limited.toTolerance = toTolerance
    }
  })

  it('unless it has just ended by itself', () => {
    const limited = limits as { toTolerance: object }
    const { toTolerance } = limited
    const experiment: Experiment = {
      ...{ scene: 'half-pipe', parameters: { position: 0, speed: 8 }, duration: 1 },
      ...{ integrator: 'velocity-verlet', timestep: { kind: 'tolerance', tolerance: 1e-9 } },
    }
    const whole = simulate(experiment)
    expect(whole.outcome.kind).toBe('left-the-track')
    limited.toTolerance = { evaluationsAnOrder: (whole.evaluations - 1) / 2, evaluationsAFrame: 0 }
    try {
      expect(simulate(experiment).outcome).toEqual(whole.outcome)
    } finally {
      limited.toTolerance = toTolerance
    }
  })
})
