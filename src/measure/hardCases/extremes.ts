import type { Experiment } from '../../physics/index.ts'
import type { HardCase, Claims } from './hardCase.ts'

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

/** What holds of the cases with numbers at the ends of their ranges. */
export const extremesClaims: Readonly<Record<string, Claims>> = {
  'smallest-numbers': {
    kick: {
      what: 'The smallest kick there is: how far it moves',
      why: 'what friction does in the time to which an instant can be known',
      unit: 'm',
      rounding: true,
    },
    swing: {
      what: 'A swing of 10⁻³¹⁰ m: distance from one of 10⁻²⁰⁰ m, made as small',
      why: 'roundings to 5 × 10⁻³²⁴, some ten a step',
      unit: 'm',
      rounding: true,
    },
  },
  'largest-numbers': {
    error: {
      what: 'Located stops, methods of second order and more: largest error',
      why: 'numbers around 10⁹ m lie half a micrometre apart: as much in each of 120 steps',
      unit: 'm',
    },
  },
  'zero-gravity': {
    speed: {
      what: 'Largest change of speed, with any rule of stopping',
      why: 'no force, no change: to the last bit',
      unit: 'm/s',
    },
    place: {
      what: 'Off at the end',
      why: '120 roundings of a position up to 4 m',
      unit: 'm',
      rounding: true,
    },
  },
  'zero-mass': {
    refused: {
      what: 'Experiments refused, with the mass and its range',
      why: 'no mass, no acceleration',
      unit: 'things',
    },
  },
  'zero-duration': {
    rows: {
      what: 'Rows of the run, in every scene',
      why: 'its start',
      unit: 'things',
    },
    work: {
      what: 'Steps and evaluations',
      why: 'no time to step through',
      unit: 'things',
    },
  },
}
