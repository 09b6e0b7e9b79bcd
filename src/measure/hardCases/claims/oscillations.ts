import type { Claim, Claims } from '../claim.ts'

const bounded: Claim = {
  what: 'Methods within their limit: farthest from the middle, started at 1 m',
  why: 'the start, and 60 000 roundings',
  unit: 'm',
}
const energy: Claim = {
  what: 'Implicit midpoint: largest change of the energy',
  why: 'it keeps this energy exactly; each step is solved to some roundings',
  unit: 'of the energy',
  rounding: true,
}
const diverged: Claim = {
  what: 'Methods beyond their limit: steps until the run is called diverged',
  why: 'the growth of the method’s step matrix, up to a factor of a thousand',
  unit: 'things',
  failure: 'diverges',
}
const spring: Claims = { bounded, energy, diverged }

const band = (method: string, power: string): Claim => ({
  what: `${method}: largest change of the energy in 10 000 s`,
  why: `a symplectic method’s energy is off by (ωΔt)${power} of itself, and no more with time`,
  unit: 'of the energy',
})

/** What holds of the cases of swings. */
export const oscillationsClaims: Readonly<Record<string, Claims>> = {
  'pipe-from-89-degrees': {
    'semi-implicit-euler': band('Semi-implicit Euler', ''),
    'velocity-verlet': band('Velocity Verlet', '²'),
    'implicit-midpoint': band('Implicit midpoint', '²'),
    yoshida4: band('Yoshida 4', '⁴'),
    drift: {
      what: 'These four: what all but the first 100 s add to that',
      why: 'a hundredth of it, and a random walk of 600 000 roundings',
      unit: 'of the energy',
    },
    rk4: {
      what: 'Runge–Kutta 4: loss of energy in 10 000 s',
      why: 'at most (ωΔt)⁶/72 a step, less on swings as wide as these, but a tenth at least',
      unit: 'of the energy',
    },
    'explicit-euler': {
      what: 'Explicit Euler: time until it leaves the pipe',
      why: 'it gains energy, and the lip is 1.75 % away: in one of the first swings',
      unit: 's',
      failure: 'leaves the pipe',
    },
    midpoint: {
      what: 'Midpoint: time until it leaves the pipe',
      why: 'it gains energy too, but as a method of second order',
      unit: 's',
      failure: 'leaves the pipe',
    },
  },
  'below-verlets-limit': {
    bounded,
    ellipse: {
      what: 'Semi-implicit Euler: the same',
      why: 'it keeps an ellipse of half-axis 1/√(1 − (ωΔt/2)²), and comes near its end',
      unit: 'm',
    },
    energy,
    diverged,
  },
  'at-verlets-limit': {
    ...spring,
    linear: {
      what: 'Semi-implicit Euler: distance, over 2 m a step and 1 m',
      why: 'at the limit itself every step adds as much as the one before',
      unit: 'things',
      failure: 'grows',
    },
  },
  'beyond-verlets-limit': spring,
  'below-rk4s-limit': spring,
  'beyond-rk4s-limit': spring,
  'stiff-as-steel': {
    energy,
    evaluations: {
      what: 'Implicit midpoint: evaluations a step',
      why: 'a line through two points solves a spring’s equation; a third look sees that it has',
      unit: 'things',
    },
    diverged: {
      what: 'All other methods: frames until the run is called diverged',
      why: 'a step multiplies the swing by hundreds',
      unit: 'things',
      failure: 'diverges',
    },
  },
  'many-reversals': {
    found: {
      what: 'All but explicit Euler: turns found in the first second',
      why: 'each half swing ends with one: √4000/π',
      unit: 'things',
    },
    error: {
      what: 'The same: largest error',
      why: 'by what each method’s frequency is off, a power of ωΔt',
      unit: 'm',
    },
    'explicit-euler': {
      what: 'Explicit Euler: time until it diverges',
      why: 'it gains (ωΔt)² a step',
      unit: 's',
      failure: 'diverges',
    },
  },
  'many-reversals-in-a-step': {
    ends: {
      what: 'Evaluations a step',
      why: 'a hundred jumps, each found in a hundred tries of four evaluations',
      unit: 'things',
    },
    wrong: {
      what: 'Off at the end',
      why: 'no method is right with a step as long as a quarter of a swing',
      unit: 'm',
      failure: 'goes wrong, but ends',
    },
  },
}
