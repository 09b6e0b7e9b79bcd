/** One hash over the bits of many runs: in Node here, and of every other engine in engines.test.ts. */
import { describe, expect, it } from 'vitest'
import { fingerprint, fingerprintExperiments } from '../../src/measure/index.ts'
import {
  frameClocks,
  integrators,
  measuring,
  scenes,
  simulate,
  stoppings,
  timesteps,
} from '../../src/physics/index.ts'
import committed from './fingerprint.json'

describe('the fingerprint', () => {
  // Whoever means to change what the physics computes copies the new hash into fingerprint.json, and says why.
  it('is the one that is committed', () => {
    expect(fingerprint()).toEqual(committed)
  })

  it('is of every scene, method and rule, with every policy and clock in pairs', () => {
    const experiments = fingerprintExperiments()
    const combinations = (key: (each: (typeof experiments)[number]) => string) =>
      new Set(experiments.map(key)).size
    expect(
      combinations(({ scene, integrator, stopping }) => `${scene} ${integrator} ${stopping}`),
    ).toBe(scenes.length * integrators.length * stoppings.length)
    expect(combinations(({ timestep, frames }) => `${timestep!.kind} ${frames!.kind}`)).toBe(
      timesteps.length * frameClocks.length,
    )
    expect(combinations(({ timestep, stopping }) => `${timestep!.kind} ${stopping}`)).toBe(
      timesteps.length * stoppings.length,
    )
    expect(combinations(({ timestep, frames }) => `${timestep!.kind} ${frames!.delta}`)).toBe(
      timesteps.length * measuring.delta.choices.length,
    )
    expect(experiments.length).toBeGreaterThanOrEqual(200)
  })

  it('is of runs that stop, go on, leave the track and diverge', () => {
    const outcomes = fingerprintExperiments().map((each) => simulate(each).outcome.kind)
    expect(new Set(outcomes).size).toBe(4)
  })

  it('is FNV-1a of all their bytes', () => {
    let hash = 0xcbf29ce484222325n
    const view = new DataView(new ArrayBuffer(8))
    const add = (value: number) => {
      view.setFloat64(0, value, true)
      for (let i = 0; i < 8; i++)
        hash = BigInt.asUintN(64, (hash ^ BigInt(view.getUint8(i))) * 0x100000001b3n)
    }
    for (const experiment of fingerprintExperiments()) {
      const run = simulate(experiment)
      for (const name of ['time', 'stateTime', 's', 'v', 'drawnS', 'heat'] as const)
        run[name].forEach(add)
      for (const name of ['frames', 'steps', 'evaluations', 'unsolved', 'lostTime'] as const)
        add(run[name])
      add(run.outcome.time)
    }
    expect(fingerprint().hash).toBe(hash.toString(16).padStart(16, '0'))
  })
})
