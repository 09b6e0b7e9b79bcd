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
      'A block kicked at the smallest speed there is, 5 × 10⁻³²⁴ m/s, and a pipe whose swings are 10⁻³¹⁰ m: nothing happens that should not.',
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
      'At 10⁹ m/s and 10⁹ m from the start neighbouring numbers lie a tenth to half a micrometre apart, and each step rounds to one of them.',
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
    experiments: [0, 2].map((speed) => ramp({ gravity: 0, speed })),
  },
  {
    id: 'zero-mass',
    group: 16,
    label: 'No mass',
    watch: 'A block of no mass has no acceleration: the experiment is refused, with the reason.',
    experiments: [ramp({ mass: 0 })],
    refused: true,
  },
  {
    id: 'zero-duration',
    group: 16,
    label: 'No duration',
    watch: 'A run of 0 s is its start, and nothing else.',
    experiments: [{ ...ramp({ speed: 1 }), duration: 0 }],
  },
]
