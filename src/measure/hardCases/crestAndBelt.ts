import type { Experiment } from '../../physics/index.ts'
import type { Claims, HardCase } from './hardCase.ts'

/** From the top of a crest of 45° and 3 m, at 3 m/s. */
const fromTheTop: Experiment = {
  scene: 'crest',
  parameters: {
    ...{ angle: 45, crestRadius: 3, muStatic: 0, muKinetic: 0 },
    // 3 m × π/4, rounded.
    ...{ position: 2.356194490192345, speed: 3 },
  },
  integrator: 'rk8',
  duration: 2,
}

/** At the foot of an arc of 20° with v² = g R cos 20° (1 + excess), from 2 m before it. */
const atTheFoot = (excess: number): Experiment => ({
  scene: 'crest',
  parameters: {
    ...{ angle: 20, crestRadius: 3, muStatic: 0, muKinetic: 0, position: -2 },
    // g R cos 20°, and 4 g sin 20° for the slope.
    speed: Math.sqrt(27.655153829729286 * (1 + excess) + 13.420870424099242),
  },
  frames: { kind: 'steady', fps: 10 },
  duration: 3,
})

const hill: Experiment = {
  scene: 'crest',
  parameters: {
    ...{ angle: 20, crestRadius: 3, muStatic: 0.1, muKinetic: 0.1, position: -2, speed: 7 },
  },
  frames: { kind: 'steady', fps: 10 },
  duration: 2,
}

const riding: Experiment = {
  scene: 'belt',
  parameters: {
    ...{ beltSpeed: 0.5, stiffness: 40, muStatic: 0.5, muKinetic: 0.3, speed: 0.5 },
  },
  integrator: 'rk8',
  duration: 20,
}

/** Where a block takes off, and where it sticks and slips. */
export const crestAndBelt: readonly HardCase[] = [
  {
    id: 'stick-and-slip',
    group: 23,
    label: 'Stick and slip',
    watch:
      'The block rides on the belt until the spring tears it off, slips back, and sticks again. By the naive rule it never sticks.',
    experiments: [
      riding,
      { ...riding, stopping: 'clamped' },
      { ...riding, stopping: 'naive' },
      { ...riding, integrator: 'semi-implicit-euler', stopping: 'naive' },
    ],
  },
  {
    id: 'ten-thousand-cycles',
    group: 23,
    label: 'Ten thousand cycles of stick and slip',
    watch:
      'After nearly three hours the block sticks and slips at the instants of the closed form.',
    experiments: [{ ...riding, duration: 10140 }],
  },
  {
    id: 'take-off-beyond-the-top',
    group: 24,
    label: 'Takes off beyond the top',
    watch: 'At any frame rate the block leaves the hill at one place and one instant.',
    experiments: [5, 10, 60, 240].map((fps) => ({
      ...fromTheTop,
      frames: { kind: 'steady', fps },
      timestep: { kind: 'tolerance', tolerance: 1e-9 },
    })),
  },
  {
    id: 'take-off-by-a-billionth',
    group: 24,
    label: 'Takes off, by a billionth',
    watch: 'One block is faster by a billionth than the crest can hold, the other slower.',
    experiments: [atTheFoot(1e-9), atTheFoot(-1e-9)],
  },
  {
    id: 'take-off-missed',
    group: 24,
    label: 'A take-off that frames miss',
    watch:
      'The block takes off where the crest begins. At 10 fps clamped and naive blocks look too late, and one never does.',
    experiments: [
      hill,
      { ...hill, stopping: 'clamped' },
      { ...hill, stopping: 'naive' },
      { ...hill, stopping: 'clamped', integrator: 'semi-implicit-euler' },
    ],
  },
]

/** What holds of these cases. */
export const crestAndBeltClaims: Readonly<Record<string, Claims>> = {
  'stick-and-slip': {
    rides: {
      what: 'While it rides, located stops, any method of second order or more: speed less the belt’s',
      why: 'it is set to the belt’s speed, to the bit',
      unit: 'm/s',
    },
    period: {
      what: 'To a tolerance of 10⁻⁹ m/s, Verlet, Runge–Kutta 4 and 8: off after 20 s',
      why: 'the tolerance for 20 s',
      unit: 'm',
    },
    clamped: {
      what: 'Clamped stops, a step a frame: off after 20 s',
      why: 'each release and each catch comes up to a frame late',
      unit: 'm',
      failure: 'out of step',
    },
    naive: {
      what: 'Naive stops: smallest distance from the belt’s speed in a frame',
      why: 'without static friction no step ends at that speed, but by chance',
      unit: 'm/s',
      failure: 'never rides',
    },
  },
  'ten-thousand-cycles': {
    period: {
      what: 'Runge–Kutta 8, a step a frame: its period, off from the closed form by',
      why: '(ωΔt)⁹ of a swing, and some hundred roundings',
      unit: 's',
    },
    top: {
      what: 'Farthest along, off from the closed form by',
      why: 'the nearest of 600 000 frames is within microseconds of it: ½ a Δt²',
      unit: 'm',
    },
    bottom: {
      what: 'Farthest back, the same',
      why: 'the same',
      unit: 'm',
    },
  },
  'take-off-beyond-the-top': {
    place: {
      what: 'To a tolerance of 10⁻⁹ m/s, Verlet, Runge–Kutta 4 and 8, 5 to 240 fps: place, off from cos θ = (2 + v²/(g R))/3 by',
      why: 'ten times the tolerance for the second that it takes',
      unit: 'm',
    },
    time: {
      what: 'The same: instant, spread over the frame rates',
      why: 'that way, at 5 m/s',
      unit: 's',
    },
    speed: {
      what: 'The same: speed, off from √(g R cos θ) by',
      why: 'that way, and the slope that it is on',
      unit: 'm/s',
    },
    clamped: {
      what: 'Clamped and naive stops at 10 fps, methods of second order and more: instant, late by',
      why: 'they look at the ends of frames only: up to a frame',
      unit: 's',
      failure: 'takes off late',
    },
  },
  'take-off-by-a-billionth': {
    over: {
      what: 'Too fast, methods of second order and more at 10 fps: place, off from the crest’s beginning',
      why: 'on the straight they are exact, and the joint is found to the bit',
      unit: 'm',
    },
    under: {
      what: 'Not too fast, the same: time at which it is on the hill still',
      why: 'where the crest begins, after 0.34 s, it holds, and on the way up the block gets slower',
      unit: 's',
    },
    rk8: {
      what: 'Not too fast, Runge–Kutta 8 at 10 fps: how long it stays on the hill, of 3 s',
      why: 'the way down mirrors the way up, and its errors are below a billionth',
      unit: 's',
    },
    verlet: {
      what: 'Not too fast, velocity Verlet at 10 fps: time at which it leaves',
      why: 'at the crest’s other end, after 0.76 s, its error decides about a billionth',
      unit: 's',
      failure: 'takes off',
    },
    explicit: {
      what: 'Not too fast, explicit Euler at 10 fps: time at which it leaves',
      why: 'it is ahead of the true block by ½ a t Δt, and so too fast at every place',
      unit: 's',
      failure: 'takes off',
    },
    'semi-implicit': {
      what: 'Too fast, semi-implicit Euler at 10 fps: how long it stays, of 3 s',
      why: 'it is behind by as much, and too slow',
      unit: 's',
      failure: 'stays on the ground',
    },
  },
  'take-off-missed': {
    located: {
      what: 'Located stops, methods of second order and more, 5 to 240 fps: instant, off by',
      why: 'some roundings',
      unit: 's',
      rounding: true,
    },
    late: {
      what: 'Clamped and naive stops at 10 fps, the same methods: instant, late by',
      why: 'a frame sees no crest until it ends on one, and by then the block may be too slow to leave',
      unit: 's',
      failure: 'takes off late',
    },
    never: {
      what: 'Clamped and naive stops at 10 fps, semi-implicit Euler: how long it stays, of 2 s',
      why: 'its first frame on the crest ends where the block is slow enough to hold',
      unit: 's',
      failure: 'stays on the ground',
    },
  },
}
