import type { Experiment, IntegratorId } from '../../physics/index.ts'
import type { HardCase, Claim, Claims } from './hardCase.ts'

const every: readonly IntegratorId[] = [
  'explicit-euler',
  'semi-implicit-euler',
  'velocity-verlet',
  'midpoint',
  'rk4',
  'yoshida4',
  'implicit-midpoint',
]
const by = (methods: readonly IntegratorId[], experiment: Experiment): Experiment[] =>
  methods.map((integrator) => ({ ...experiment, integrator }))

const STEP = 1 / 60
/** A spring of 1 kg without friction, released at 1 m, at that ωΔt. */
const swinging = (omegaDt: number, duration: number): Experiment => ({
  scene: 'spring',
  parameters: {
    angle: 0,
    // Without digits that are rounding: addresses show it.
    stiffness: Number(((omegaDt / STEP) * (omegaDt / STEP)).toPrecision(15)),
    muStatic: 0,
    muKinetic: 0,
    position: 1,
  },
  timestep: { kind: 'fixed', step: STEP },
  duration,
})
const reversing: Experiment = {
  scene: 'spring',
  parameters: { angle: 30, stiffness: 4000, muStatic: 0.3, muKinetic: 0.2, position: 0.1 },
  frames: { kind: 'steady', fps: 1 },
  duration: 4,
}

/** Energy over thousands of swings, and steps at and beyond what a method can bear. */
export const oscillations: readonly HardCase[] = [
  {
    id: 'pipe-from-89-degrees',
    group: 9,
    label: 'A pipe, from a degree below its lip',
    watch:
      'A gain of 1.8 % in energy throws the block out: explicit Euler in its first swing, midpoint after 23 minutes, the others never.',
    experiments: by(every, {
      scene: 'half-pipe',
      // 89° on a radius of 2 m.
      parameters: { radius: 2, position: 3.1066860685499065, muStatic: 0, muKinetic: 0 },
      duration: 10000,
    }),
  },
  {
    id: 'below-verlets-limit',
    group: 10,
    label: 'A spring at ωΔt = 1.99',
    watch: 'Six steps make two swings: ugly, but Verlet and semi-implicit Euler stay bounded.',
    experiments: by(every, swinging(1.99, 1000)),
  },
  {
    id: 'at-verlets-limit',
    group: 10,
    label: 'A spring at ωΔt = 2.00',
    watch:
      'At the very limit Verlet and semi-implicit Euler grow no faster than the number of steps.',
    experiments: by(every, swinging(2, 1000)),
  },
  {
    id: 'beyond-verlets-limit',
    group: 10,
    label: 'A spring at ωΔt = 2.01',
    watch: 'Verlet grows by 22 % every step and has diverged within a second.',
    experiments: by(every, swinging(2.01, 1000)),
  },
  {
    id: 'below-rk4s-limit',
    group: 10,
    label: 'A spring at ωΔt = 2.82',
    watch: 'Runge–Kutta 4 is stable here, by losing nine tenths of its energy within a second.',
    experiments: by(every, swinging(2.82, 1000)),
  },
  {
    id: 'beyond-rk4s-limit',
    group: 10,
    label: 'A spring at ωΔt = 2.83',
    watch: 'Runge–Kutta 4 grows by 0.4 % every step: it takes half a minute to diverge.',
    experiments: by(every, swinging(2.83, 1000)),
  },
  {
    id: 'stiff-as-steel',
    group: 11,
    label: 'A stiffness of 10⁹ N/m',
    watch:
      'At ωΔt = 527 implicit midpoint keeps its energy; every other method is gone in three frames.',
    experiments: by(every, swinging(Math.sqrt(1e9) / 60, 100)),
  },
  {
    id: 'many-reversals',
    group: 12,
    label: 'Twenty reversals in one frame',
    watch: 'Each frame of a second holds twenty turns; steps of 1 ms find all of them.',
    experiments: by(every, { ...reversing, timestep: { kind: 'substeps', step: 0.001 } }),
  },
  {
    id: 'many-reversals-in-a-step',
    group: 12,
    label: 'Twenty reversals in one step',
    watch:
      'Located stops cut each step to a quarter of a swing, still too long for every method: all go wrong, and none hangs.',
    experiments: by(every, reversing),
  },
]

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
