import type { Experiment, IntegratorId } from '../../physics/index.ts'
import type { Claims, HardCase } from './hardCase.ts'

const highOrder: readonly IntegratorId[] = [
  'velocity-verlet',
  'midpoint',
  'rk4',
  'rk8',
  'yoshida4',
  'implicit-midpoint',
]

const hitched: Experiment = {
  scene: 'run-out',
  parameters: {
    ...{ angle: 5.5, length: 7, bendRadius: 0.3, muStatic: 0.39, muKinetic: 0.39 },
    ...{ position: -1.05, speed: 11.6 },
  },
  frames: { kind: 'hitch', fps: 60, every: 0.7, length: 2 },
  duration: 4,
}

/** A half-pipe whose block has a little more or less energy than its lip takes, in parts of that. */
const toTheLip = (excess: number): Experiment => ({
  scene: 'half-pipe',
  parameters: {
    ...{ radius: 2, muStatic: 0, muKinetic: 0, position: 0 },
    speed: Math.sqrt(2 * 9.81 * 2 * (1 + excess)),
  },
  integrator: 'rk8',
  timestep: { kind: 'substeps', step: 0.001 },
  duration: 6,
})

const overAndBack: Experiment = {
  scene: 'half-pipe',
  // 3 cm below the lip, and so fast that it crosses it at 0.5 m/s.
  parameters: { radius: 2, muStatic: 0, muKinetic: 0, position: 3.11, speed: 0.935 },
  frames: { kind: 'steady', fps: 5 },
  duration: 1,
}

/** A crest of 20° and 3 m, from 2 m below it, with a little more or less energy than its top takes. */
const toTheTop = (excess: number): Experiment => ({
  scene: 'crest',
  parameters: {
    ...{ angle: 20, crestRadius: 3, muStatic: 0, muKinetic: 0, position: -2 },
    // 2 g (2 sin 20° + 3 (1 − cos 20°)), rounded.
    speed: Math.sqrt(16.970562764640672 * (1 + excess)),
  },
  integrator: 'rk8',
  timestep: { kind: 'substeps', step: 0.001 },
  duration: 14,
})

const fromRest = (angle: number): Experiment => ({
  scene: 'run-out',
  parameters: { angle, length: 0, bendRadius: 1.5, muStatic: 0, muKinetic: 0 },
  integrator: 'rk8',
  duration: 3,
})

/** Places so small, or met so slowly, that a step passes over them. */
export const edges: readonly HardCase[] = [
  {
    id: 'bend-shorter-than-a-step',
    group: 18,
    label: 'A bend of 3 cm under a hitch of 2 s',
    watch:
      'The long frame holds the slope, the bend and half of the flat. Every method comes out of it within a millimetre.',
    experiments: highOrder.map((integrator) => ({ ...hitched, integrator })),
  },
  {
    id: 'lip-by-a-billionth',
    group: 19,
    label: 'The lip, by a billionth of the energy',
    watch:
      'One block has a billionth more energy than the lip takes and leaves the pipe. The other has a billionth less and stays in it.',
    experiments: [toTheLip(1e-9), toTheLip(-1e-9)],
  },
  {
    id: 'over-and-back-in-a-step',
    group: 19,
    label: 'Over the lip and back in one step',
    watch:
      'Without its lip the pipe would have the block back within one frame of 0.2 s. It has left all the same.',
    experiments: highOrder.map((integrator) => ({ ...overAndBack, integrator })),
  },
  {
    id: 'top-by-a-billionth',
    group: 19,
    label: 'A hilltop, by a billionth of the energy',
    watch:
      'Both all but stop at the top for seconds. Then one goes down the far side and the other comes back.',
    experiments: [toTheTop(1e-9), toTheTop(-1e-9)],
  },
  {
    id: 'bends-from-rest',
    group: 20,
    label: 'The reference, on bends from rest',
    watch:
      'The outline is the reference that all errors are measured against. The block beside it is Runge–Kutta 8.',
    experiments: [15, 30, 45, 60, 90].map(fromRest),
  },
]

/** What holds of the cases of bends, lips and tops. */
export const edgesClaims: Readonly<Record<string, Claims>> = {
  'bend-shorter-than-a-step': {
    located: {
      what: 'Located stops, methods of second order and more, bends of 0.01 to 0.3 m, hitches of 0.25 to 2 s: off at the end',
      why: 'the speed falls by μθ of itself along the bend; one step is wrong by (μθ)³/3, and the way to go by twice that',
      unit: 'm',
    },
    rk8: {
      what: 'Runge–Kutta 8: the same',
      why: '(μθ)⁹ is nothing: some thousand roundings of 17 m',
      unit: 'm',
      rounding: true,
    },
    clamped: {
      what: 'Clamped stops: the same',
      why: 'a step passes over the bend, whose press takes μθ of the speed, and so 2μθ of the 10.7 m to go on the flat',
      unit: 'm',
      failure: 'passes over the bend',
    },
  },
  'lip-by-a-billionth': {
    over: {
      what: 'Enough energy, Runge–Kutta 8 in steps of 1 ms: how far from the lip it leaves',
      why: 'a located lip is the lip, to the bit',
      unit: 'm',
    },
    under: {
      what: 'Not enough, the same: off after 6 s',
      why: 'some roundings of 3 m in each of 6000 steps',
      unit: 'm',
      rounding: true,
    },
    euler: {
      what: 'Not enough, explicit Euler at 60 fps: time until it leaves',
      why: 'it gains energy on its first way up already: half a swing lasts 0.84 s',
      unit: 's',
      failure: 'leaves the pipe',
    },
  },
  'over-and-back-in-a-step': {
    located: {
      what: 'Located stops, methods of second order and more: time at which it leaves, off by',
      why: 'a sixth of Δt³ times the rate at which gravity turns on those 3 cm, at 0.5 m/s',
      unit: 's',
    },
    clamped: {
      what: 'Clamped stops, the same methods: time in the pipe, in a run of 1 s',
      why: 'they look for the lip at the end of a frame, and by then the block is back',
      unit: 's',
      failure: 'stays in the pipe',
    },
  },
  'top-by-a-billionth': {
    over: {
      what: 'Enough energy, Runge–Kutta 8 in steps of 1 ms: off at the end',
      why: 'the roundings of 14 000 steps are 3 × 10⁻³ of that billionth, and shift the pass by as much of 1/ω',
      unit: 'm',
    },
    under: {
      what: 'Not enough, the same: off at the end',
      why: 'the same',
      unit: 'm',
    },
    euler: {
      what: 'Enough energy, semi-implicit Euler at 60 fps: short of the top by',
      why: 'on the straight alone it falls behind by ½ a T Δt, and the flat top asks for the root of that',
      unit: 'm',
      failure: 'comes back',
    },
  },
  'bends-from-rest': {
    itself: {
      what: 'On 1000 random bends, 15° to 90°: the reference in one go, and in two',
      why: 'it answers to 10⁻¹¹ of the path or not at all; the second part doubles that',
      unit: 'things',
    },
    energy: {
      what: 'On those without friction: its change of the energy',
      why: 'what it must know of its own error',
      unit: 'things',
    },
    rk8: {
      what: 'Runge–Kutta 8 in steps of 2 ms: distance from the reference, in parts of the path',
      why: 'a step is at most 0.03 of the time that the sharpest bend takes; both are far better than that',
      unit: 'things',
    },
  },
}
