import { expect, test } from 'vitest'
import { simulate } from '../../../src/physics/index.ts'
import type { Experiment } from '../../../src/physics/index.ts'
import { endText } from '../../../src/panels/runners/results.ts'

const text = (experiment: Experiment) =>
  endText(simulate(experiment)).text.replaceAll('\u202f', ' ')
const kick = { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5, gravity: 9.81 }

test.each([
  ['0.69 s · 1.72 m', { scene: 'ramp', parameters: kick, duration: 1 }],
  ['moving', { scene: 'ramp', parameters: kick, duration: 0.5 }],
  // The last frame of all ends with a speed of 0, and whether it stays is for the next.
  [
    'at a stop',
    {
      scene: 'ramp',
      parameters: kick,
      frames: { kind: 'steady', fps: 10 },
      integrator: 'semi-implicit-euler',
      stopping: 'clamped',
      duration: 0.7,
    },
  ],
  // On the wall's clock: at 6 frames a second of 1/60 s each, all takes ten times as long.
  [
    '7.00 s · 1.68 m',
    {
      scene: 'ramp',
      parameters: kick,
      frames: { kind: 'steady', fps: 6 },
      timestep: { kind: 'per-frame', step: 1 / 60 },
      integrator: 'semi-implicit-euler',
      stopping: 'clamped',
      duration: 20,
    },
  ],
] satisfies [string, Experiment][])('%s', (expected, experiment) => {
  expect(text(experiment)).toBe(expected)
})

test('what else may become of a run', () => {
  expect(
    text({
      scene: 'spring',
      parameters: { stiffness: 1e6, muStatic: 0, muKinetic: 0, position: 1 },
      integrator: 'explicit-euler',
      duration: 5,
    }),
  ).toMatch(/^diverged \d+ ms$/)
  expect(
    text({ scene: 'half-pipe', parameters: { speed: 30, muStatic: 0, muKinetic: 0 }, duration: 5 }),
  ).toMatch(/^left the track \d/)
})
