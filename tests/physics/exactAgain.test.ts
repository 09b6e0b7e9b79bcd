/** The exact motion beside a method of the eighth order in short steps: the cases of which only one thing is odd. */
import { describe, expect, it } from 'vitest'
import { exact, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { last } from './truth.ts'

/** 17° of 30° are left at 0.34 m of the bend, whose tangent is 0.31. */
const onTheBend = {
  ...{ angle: 30, length: 4, bendRadius: 1.5 },
  ...{ position: 4.34, speed: 0, muKinetic: 0.05 },
}

const cases: [string, Experiment][] = [
  [
    'lets go in a pipe where tan θ is above μs, though sin θ is below',
    {
      scene: 'half-pipe',
      parameters: { radius: 2, position: 1.6, speed: 0, muStatic: 0.9, muKinetic: 0.3 },
      duration: 3,
    },
  ],
  [
    'lets go on the bend of a run-out, by the slope that is there',
    {
      scene: 'run-out',
      parameters: { ...onTheBend, muStatic: 0.29 },
      duration: 1.5,
    },
  ],
  [
    'holds on the bend of a run-out, by the slope that is there',
    {
      scene: 'run-out',
      parameters: { ...onTheBend, muStatic: 0.33 },
      duration: 1.5,
    },
  ],
  ...[-0.4, 0.9].map((position): [string, Experiment] => [
    `swings on a spring with friction, let go at ${position} m`,
    {
      scene: 'spring',
      parameters: {
        angle: 20,
        stiffness: 40,
        muStatic: 0.1,
        muKinetic: 0.08,
        mass: 1,
        position,
        speed: 0,
      },
      duration: 3,
    },
  ]),
  ...[3, -5].map((speed): [string, Experiment] => [
    `swings for ever in a pipe without friction, pushed at ${speed} m/s`,
    {
      scene: 'half-pipe',
      parameters: { radius: 2, position: 0.7, speed, muStatic: 0, muKinetic: 0 },
      duration: 20,
    },
  ]),
]

describe('the exact motion', () => {
  it.each(cases)('%s', (_, experiment) => {
    const run = simulate({
      ...experiment,
      integrator: 'rk8',
      stopping: 'located',
      timestep: { kind: 'substeps', step: 1 / 1000 },
    })
    for (let row = 0; row <= run.frames; row += 7) {
      const { s, v } = exact(run.experiment, run.time[row]!)
      // A thousand steps a second of the eighth order leave rounding: some ulps a step, magnified by the swings.
      expect(run.s[row]).toBeCloseTo(s, 10)
      expect(run.v[row]).toBeCloseTo(v, 10)
    }
    expect(last(run.time)).toBe(experiment.duration)
  })
})
