import type { Experiment } from '../../physics/index.ts'
import type { HardCase } from './hardCase.ts'

const ramp = (parameters: Experiment['parameters']): Experiment => ({
  scene: 'ramp',
  parameters: { ...parameters },
})

/** Numbers at the ends of their ranges. */
export const extremes: readonly HardCase[] = [
  {
    id: 'smallest-numbers',
    group: 13,
    label: 'The smallest numbers there are',
    watch:
      'A block kicked at 5e-324 m/s, and a pipe whose swings are 1e-310 m: nothing happens that should not.',
    claim: 'No result is NaN or infinite, and a tiny swing is a small one made smaller.',
    experiments: [
      ramp({ angle: 10, muStatic: 0.5, muKinetic: 0.5, speed: 5e-324 }),
      { scene: 'half-pipe', parameters: { position: 1e-310 } },
      { scene: 'half-pipe', parameters: { position: 1e-200 } },
    ],
  },
  {
    id: 'largest-numbers',
    group: 13,
    label: 'The largest numbers allowed',
    watch:
      'At 1e9 m/s and 1e9 m from the start an ulp is a tenth of a micrometre, and errors are of that size.',
    claim: 'Located methods of second order are off by an ulp of the position a step at the most.',
    experiments: [
      ramp({ speed: 1e9 }),
      ramp({ speed: -1e9 }),
      ramp({ position: 1e9 }),
      ramp({ position: -1e9 }),
    ],
  },
  {
    id: 'zero-gravity',
    group: 16,
    label: 'No gravity',
    watch: 'No weight, no press, no friction: everything keeps its speed.',
    claim: 'On a straight the speed keeps its bits, and a block at rest stays.',
    experiments: [0, 2].map((speed) => ramp({ gravity: 0, speed })),
  },
  {
    id: 'zero-mass',
    group: 16,
    label: 'No mass',
    watch: 'A block of no mass has no acceleration: the experiment is refused, with the reason.',
    claim: 'It is refused, and the message names the mass and its range.',
    experiments: [ramp({ mass: 0 })],
    refused: true,
  },
  {
    id: 'zero-duration',
    group: 16,
    label: 'No duration',
    watch: 'A run of 0 s is its start, and nothing else.',
    claim: 'One row, no frame, no step.',
    experiments: [{ ...ramp({ speed: 1 }), duration: 0 }],
  },
]
