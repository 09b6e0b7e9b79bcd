import type { Claims } from '../claim.ts'

const rough: Claims = {
  located: {
    what: 'Located stops, methods of second order and more: largest error',
    why: 'a rounding of 1.6 m in each of 180 steps',
    unit: 'm',
    rounding: true,
  },
  same: {
    what: 'The same: distance from where it ends at a steady 60 fps',
    why: 'the same roundings',
    unit: 'm',
    rounding: true,
  },
  euler: {
    what: 'Located stops, the two Euler methods: off at the end',
    why: '½ a Σ Δt², some centimetres at 60 fps already',
    unit: 'm',
    failure: 'stops in the wrong place',
  },
  paper: {
    what: 'The paper’s step: off at the end',
    why: 'it is of first order, and its stops are naive',
    unit: 'm',
    failure: 'ends elsewhere, and never rests',
  },
}

/** What holds of the cases of frames and clocks. */
export const framesClaims: Readonly<Record<string, Claims>> = {
  'half-second-hitch': rough,
  'five-fps': rough,
  'wild-jitter': rough,
  'long-clock': {
    run: {
      what: 'A run of a million frames: how far its clock is off at any of them',
      why: 'frames are counted, and their number divided by the rate once',
      unit: 's',
    },
    clock: {
      what: 'The clock after ten million frames: off by',
      why: 'the same',
      unit: 's',
    },
    loop: {
      what: 'A game’s loop that adds ten million frame times: off by',
      why: 'one rounding of the sum',
      unit: 's',
      rounding: true,
    },
  },
  'spiral-of-death': {
    whole: {
      what: 'Without a bound: steps in 20 s',
      why: '20 s in steps of a millisecond',
      unit: 'things',
    },
    steps: {
      what: 'With a bound: steps a frame',
      why: 'the bound',
      unit: 'things',
    },
    lost: {
      what: 'The same: time dropped, as reported',
      why: '1950 steps of a millisecond in each of ten frames',
      unit: 's',
    },
    same: {
      what: 'The same: distance from the run without a bound after as many steps',
      why: 'the same steps, so the same bits',
      unit: 'm',
    },
  },
}
