import { integrators } from '../../physics/index.ts'
import type { Experiment, FramesChoice } from '../../physics/index.ts'
import type { Claims, HardCase } from './hardCase.ts'

const ids = integrators.map(({ id }) => id)

const steep: Experiment = {
  scene: 'ramp',
  parameters: { angle: 45, muStatic: 1, muKinetic: 1 },
  duration: 3600,
}
const level: Experiment = {
  scene: 'ramp',
  parameters: { angle: 0, muStatic: 0, muKinetic: 0 },
  duration: 3600,
}
const spring: Experiment = {
  scene: 'spring',
  // k x = μs m g, to rounding.
  parameters: {
    ...{ angle: 0, stiffness: 40, muStatic: 0.5, muKinetic: 0.4 },
    position: (0.5 * 9.81) / 40,
  },
  duration: 3600,
}

/** A ball that only air acts on, whose first step at 10 fps has that c v Δt/m. */
const inAir = (z: number): Experiment[] =>
  ids.map((integrator) => ({
    scene: 'fall',
    parameters: { gravity: 0, drag: 10, speed: z },
    ...{ integrator, stopping: 'naive', frames: { kind: 'steady', fps: 10 }, duration: 10 },
  }))

const dive: Experiment = {
  scene: 'fall',
  parameters: { drag: 10, speed: 12 },
  ...{ integrator: 'rk8', frames: { kind: 'steady', fps: 10 }, duration: 5 },
}

const hour: Experiment = { scene: 'ramp', duration: 3600 }
const at = (fps: number): { frames: FramesChoice } => ({ frames: { kind: 'steady', fps } })

/** Ties, air that is stiff, and an hour on the way. */
export const limits: readonly HardCase[] = [
  {
    id: 'ties',
    group: 21,
    label: 'Ties of drive and friction',
    watch:
      'On 45° with μs = 1, on the flat without friction, and on a spring at k x = μs N, the block stays where it is put.',
    experiments: [steep, level, spring],
  },
  {
    id: 'below-the-limit-of-drag',
    group: 22,
    label: 'Stiff air at c v Δt/m = 1.9',
    watch:
      'One step of Euler takes away 1.9 times the speed there is. It swings to and fro, and dies down.',
    experiments: inAir(1.9),
  },
  {
    id: 'beyond-the-limit-of-drag',
    group: 22,
    label: 'Stiff air at c v Δt/m = 2.1',
    watch:
      'Euler, Verlet and midpoint end each step faster than they began it, and are gone in a second.',
    experiments: inAir(2.1),
  },
  {
    id: 'dive-into-stiff-air',
    group: 22,
    label: 'Into stiff air at c v Δt/m = 12',
    watch:
      'Six times beyond the limit of the explicit methods, implicit midpoint survives. So does Runge–Kutta 8 to tolerance, to a nanometre.',
    experiments: [
      { ...dive, timestep: { kind: 'tolerance', tolerance: 1e-9 } },
      { ...dive, integrator: 'implicit-midpoint', stopping: 'naive' },
      { ...dive, integrator: 'rk4', stopping: 'naive' },
      { ...dive, integrator: 'velocity-verlet', stopping: 'naive' },
    ],
  },
  {
    id: 'hour-of-sliding',
    group: 26,
    label: 'An hour of sliding',
    watch: 'After 20 000 km the exact methods are off by micrometres, and Euler by 96 m.',
    experiments: [
      ...[5, 60, 144].map((fps) => ({ ...hour, ...at(fps) })),
      { ...hour, integrator: 'semi-implicit-euler' },
    ],
  },
]

/** What holds of these cases. */
export const limitsClaims: Readonly<Record<string, Claims>> = {
  ties: {
    held: {
      what: 'Located or clamped stops: how far it moves in an hour',
      why: 'a tie holds, and no step is taken',
      unit: 'm',
    },
    freed: {
      what: 'On 45° with μs less by 10⁻¹²: distance after an hour, over ½ a t²',
      why: 'of the difference, 10⁻¹² of g, two roundings are 4 × 10⁻⁴',
      unit: 'things',
    },
    naive: {
      what: 'On 45°, naive stops: how far it moves in an hour',
      why: 'the paper’s formula has no friction at rest: gravity moves it first, or rounding does',
      unit: 'm',
      failure: 'creeps',
    },
  },
  'below-the-limit-of-drag': {
    survives: {
      what: 'All methods but Yoshida 4: largest speed, over the first',
      why: 'a step of Euler multiplies the speed by 1 − 1.9; of Verlet and midpoint by 0.82 and 0.995',
      unit: 'things',
    },
    yoshida: {
      what: 'Yoshida 4: steps until it is called diverged',
      why: 'its middle step goes back by 1.7 Δt, and in reverse air drives what it should brake',
      unit: 'things',
      failure: 'diverges',
    },
    rest: {
      what: 'Located stops, the two Euler methods: time at which they rest',
      why: 'their step crosses v = 0 at Δt/1.9, and air alone stops nothing',
      unit: 's',
      failure: 'stops in mid-air',
    },
  },
  'beyond-the-limit-of-drag': {
    diverged: {
      what: 'Euler, Verlet, midpoint and Yoshida 4: steps until the run is called diverged',
      why: 'a step multiplies the speed by more than 1, and the more the faster: Euler by 1.1, midpoint by 1.005 at first',
      unit: 'things',
      failure: 'diverges',
    },
    survives: {
      what: 'Runge–Kutta 4 and 8 and implicit midpoint: largest speed, over the first',
      why: 'their limits are farther off',
      unit: 'things',
    },
  },
  'dive-into-stiff-air': {
    tolerance: {
      what: 'To a tolerance of 10⁻⁹ m/s, Verlet, Runge–Kutta 4 and 8: off after 5 s',
      why: 'the tolerance for 5 s',
      unit: 'm',
    },
    implicit: {
      what: 'Implicit midpoint, a step a frame: largest speed, over the first',
      why: 'the mean of a step’s ends brakes, however long the step',
      unit: 'things',
    },
    diverged: {
      what: 'All other methods, a step a frame, naive: steps until the run is called diverged',
      why: 'a step multiplies the speed by 11 or more',
      unit: 'things',
      failure: 'diverges',
    },
  },
  'hour-of-sliding': {
    located: {
      what: 'Methods of second order and more, 5 to 144 fps: off after an hour, in parts of the path',
      why: 'half a rounding for each frame',
      unit: 'things',
    },
    tolerance: {
      what: 'The same to a tolerance of 10⁻⁹ m/s at 60 fps',
      why: 'half a rounding for each step, four a frame',
      unit: 'things',
    },
    euler: {
      what: 'The two Euler methods at 60 fps: off after an hour',
      why: '½ a T Δt',
      unit: 'm',
      failure: 'ends elsewhere',
    },
  },
}
