import { expect, it } from 'vitest'
import { exactMotion, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { Chance, secondOrder } from './generated.ts'
import { last } from './truth.ts'

/** Swings far too fast for the frames, with friction that takes thousands of them to stop one. */
function fastSwings(count: number, seed: number): Experiment[] {
  const chance = new Chance(seed)
  return Array.from({ length: count }, (_, i) => {
    const mu = chance.scale(1e-7, 1e-2)
    const friction = { muStatic: mu, muKinetic: mu }
    const experiment: Experiment =
      i % 2 === 0
        ? {
            scene: 'spring',
            parameters: { angle: 0, stiffness: chance.scale(1e4, 1e12), position: 1, ...friction },
          }
        : { scene: 'half-pipe', parameters: { gravity: chance.scale(1e3, 1e6), ...friction } }
    return {
      ...experiment,
      frames: { kind: 'steady', fps: chance.between(20, 120) },
      duration: 0.5,
    }
  })
}

it.each(secondOrder)('%s is at rest only where friction has taken the energy', (integrator) => {
  for (const experiment of fastSwings(samples(40, 400), 20261128)) {
    const { outcome, s, v } = simulate({ ...experiment, integrator })
    if (outcome.kind !== 'at-rest') continue
    // At rest, so it has to be so in truth: soon, within half of the energy that is still left to take.
    const truth = exactMotion(experiment)(4 * outcome.time, { s: 0, v: 0 })
    expect(truth.v, JSON.stringify({ ...experiment, integrator })).toBe(0)
    expect(last(v)).toBe(0)
    expect(Number.isFinite(last(s))).toBe(true)
  }
})

it('a block that friction stops is at rest, whatever the method makes of the way', () => {
  for (const integrator of secondOrder)
    for (const fps of [5, 30, 144]) {
      const kicked: Experiment = {
        scene: 'ramp',
        parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
        integrator,
        frames: { kind: 'steady', fps },
      }
      expect(simulate(kicked).outcome.kind).toBe('at-rest')
    }
})

it.each([1e-6, 1e-3, 1, 1e3, 1e5])(
  'a block that only static friction holds at its turn rests there, from %d m/s',
  (speed) => {
    for (const integrator of secondOrder)
      for (const fps of [7, 60]) {
        // Smooth while it slides: all of its energy is still there, but for the rounding of numbers of its size.
        const parameters = { angle: 15, muStatic: 0.5, muKinetic: 0, speed: -speed }
        const duration = (2 * speed) / (9.81 * Math.sin((15 * Math.PI) / 180))
        const frames = { kind: 'steady', fps: Math.max(1, fps / Math.max(speed, 1)) } as const
        const { outcome } = simulate({ scene: 'ramp', parameters, integrator, frames, duration })
        expect(outcome.kind).toBe('at-rest')
      }
  },
)
