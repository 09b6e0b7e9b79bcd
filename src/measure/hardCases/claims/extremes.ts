import type { Claims } from '../claim.ts'

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
