import { integrators } from '../../physics/index.ts'
import type { Experiment } from '../../physics/index.ts'
import type { Claims, HardCase } from './hardCase.ts'

const tight = {
  integrator: 'rk8',
  timestep: { kind: 'tolerance', tolerance: 1e-9 },
} as const

// Thirty quick half swings: by Verlet, a nanometre a second would take millions of steps.
const tenthOfAMicrometre = {
  integrator: 'rk8',
  timestep: { kind: 'tolerance', tolerance: 1e-7 },
} as const

/** A spring with friction and a step of 1/60 s, in units of half a swing. */
const halfSwings = (step: number): Experiment => ({
  scene: 'spring',
  parameters: {
    angle: 0,
    // Without digits that are rounding: addresses show it.
    stiffness: Number(((step * Math.PI * 60) ** 2).toPrecision(12)),
    ...{ muStatic: 0.3, muKinetic: 0.3, position: 0.01 },
  },
  duration: 0.5,
})

const drag: Experiment = {
  scene: 'fall',
  parameters: { drag: 0.5, speed: -5 },
  frames: { kind: 'steady', fps: 5 },
  duration: 3,
}

/** The error that was asked for, reversals that a step may hide, and heat. */
export const tolerances: readonly HardCase[] = [
  {
    id: 'to-tolerance-in-every-scene',
    group: 25,
    label: 'To a nanometre a second, in every scene',
    watch:
      'Steps of any length that the error asks for: every scene is the same at any frame rate.',
    experiments: [
      { scene: 'fall', parameters: { drag: 0.1 }, ...tight },
      { scene: 'ramp', parameters: { speed: -5 }, ...tight },
      { scene: 'run-out', ...tight },
      { scene: 'half-pipe', ...tight },
      { scene: 'spring', ...tight },
      { scene: 'crest', ...tight },
      { scene: 'belt', parameters: { speed: 0.5 }, ...tight },
    ],
  },
  {
    id: 'two-reversals-below-pi',
    group: 27,
    label: 'Reversals at ωΔt = 0.99 π',
    watch:
      'A step is nearly half a swing. A step a frame goes wrong by every method, and to tolerance each reversal is found.',
    experiments: [
      { ...halfSwings(0.99), ...tenthOfAMicrometre },
      ...(['rk8', 'implicit-midpoint', 'velocity-verlet'] as const).map((integrator) => ({
        ...halfSwings(0.99),
        integrator,
      })),
    ],
  },
  {
    id: 'two-reversals-beyond-pi',
    group: 27,
    label: 'Reversals at ωΔt = 1.01 π',
    watch:
      'A step can hold two reversals, so located stops cut it in three. That is still too long for a step a frame.',
    experiments: [
      { ...halfSwings(1.01), ...tenthOfAMicrometre },
      ...(['rk8', 'implicit-midpoint', 'velocity-verlet'] as const).map((integrator) => ({
        ...halfSwings(1.01),
        integrator,
      })),
    ],
  },
  {
    id: 'heat-of-drag',
    group: 28,
    label: 'Heat that the air takes',
    watch:
      'Motion, height and heat add up to what there was at the start, as nearly as the method’s order lets them.',
    experiments: integrators.map(({ id }) => ({ ...drag, integrator: id })),
  },
  {
    id: 'heat-of-friction',
    group: 28,
    label: 'Heat of friction in a pipe',
    watch: 'The same with friction, whose press grows with the speed.',
    experiments: integrators.map(({ id }) => ({
      scene: 'half-pipe',
      parameters: { radius: 2, muStatic: 0.2, muKinetic: 0.2, position: -2, speed: 2 },
      frames: { kind: 'steady', fps: 5 },
      duration: 1,
      integrator: id,
    })),
  },
]

const spread = (power: string) =>
  ({
    what: `Tolerance ${power} m/s, Verlet, Runge–Kutta 4 and 8, all scenes: frame-rate spread, over what was asked`,
    why: 'errors estimated are not errors known; what was asked is the tolerance for the duration',
    unit: 'things',
  }) as const

const reversals: Claims = {
  found: {
    what: 'To a tolerance of 10⁻⁷ m/s, Runge–Kutta 4 and 8: reversals found too many or too few',
    why: 'each half swing ends with one, until friction holds the block',
    unit: 'things',
  },
  error: {
    what: 'The same and Verlet: off at the end',
    why: 'ten times the tolerance for half a second',
    unit: 'm',
  },
  wrong: {
    what: 'A step a frame, any method: off at the end',
    why: 'three steps a half swing or fewer resolve nothing: a twentieth of the amplitude at the least',
    unit: 'm',
    failure: 'goes wrong, but ends',
  },
}

const heat: Claims = {
  order: {
    what: 'Power of Δt with which the energy residual falls, less the method’s order',
    why: 'heat is summed along the method’s own path, so that it is as wrong as that',
    unit: 'things',
  },
  rk8: {
    what: 'Runge–Kutta 8 in steps of 1/240 s: largest energy residual',
    why: 'roundings of up to 100 J in each of 720 steps',
    unit: 'J',
    rounding: true,
  },
}

/** What holds of these cases. */
export const tolerancesClaims: Readonly<Record<string, Claims>> = {
  'to-tolerance-in-every-scene': {
    '1e-3': spread('10⁻³'),
    '1e-6': spread('10⁻⁶'),
    '1e-9': spread('10⁻⁹'),
    price: {
      what: 'Runge–Kutta 8 to 10⁻⁹ m/s, half-pipe at 60 fps: evaluations a second',
      why: 'three steps of 11 evaluations for each frame, and a quarter more for steps refused',
      unit: 'things',
    },
    paper: {
      what: 'The paper’s step, a step a frame, scenes with a slope: the same, over a tolerance of 10⁻³ m/s',
      why: 'its error is some centimetres at 60 fps, and metres at 5',
      unit: 'things',
      failure: 'differs from rate to rate',
    },
  },
  'two-reversals-below-pi': reversals,
  'two-reversals-beyond-pi': reversals,
  'heat-of-drag': heat,
  'heat-of-friction': heat,
}
