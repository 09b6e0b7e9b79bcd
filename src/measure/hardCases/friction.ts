import type { Experiment } from '../../physics/index.ts'
import type { HardCase, Claims } from './hardCase.ts'

const uphill: Experiment = {
  scene: 'ramp',
  parameters: { angle: 20, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  duration: 3,
}
const flat: Experiment = { ...uphill, parameters: { ...uphill.parameters, angle: 0 } }
const between = { angle: 20, muStatic: 0.5, muKinetic: 0.2 }
/** tan 30°, rounded. */
const TAN_30 = 0.5773502691896257
const edge = (mu: number): Experiment => ({
  scene: 'ramp',
  parameters: { angle: 30, muStatic: mu, muKinetic: mu },
  duration: 3600,
})
const glue: Experiment = {
  scene: 'ramp',
  parameters: { angle: 20, muStatic: 1000, muKinetic: 1000, speed: -5 },
  frames: { kind: 'steady', fps: 1 },
  duration: 10,
}

const atRates = (experiment: Experiment): Experiment[] =>
  [5, 30, 144].map((fps) => ({ ...experiment, frames: { kind: 'steady', fps } }))
const byRules = (experiment: Experiment): Experiment[] =>
  (['located', 'clamped', 'naive'] as const).map((stopping) => ({ ...experiment, stopping }))

/** Stopping, staying, coming back: friction around v = 0. */
export const friction: readonly HardCase[] = [
  {
    id: 'stops-on-the-flat',
    group: 1,
    label: 'Stops on the flat, and stays',
    watch: 'All three stop at the same place at the same instant, in the middle of a frame.',
    experiments: atRates(flat),
  },
  {
    id: 'stops-uphill',
    group: 1,
    label: 'Stops uphill, and stays',
    watch: 'The three rules stop at three places, and the naive one trembles there for ever.',
    experiments: byRules({ ...uphill, frames: { kind: 'steady', fps: 10 } }),
  },
  {
    id: 'comes-back',
    group: 2,
    label: 'Stops uphill and comes back',
    watch: 'The instant of the turn lies inside a frame, and friction changes sides there.',
    experiments: atRates({
      scene: 'ramp',
      parameters: { angle: 35, muStatic: 0.3, muKinetic: 0.3, speed: -5 },
      duration: 3,
    }),
  },
  {
    id: 'held-or-sliding',
    group: 3,
    label: 'Steep enough to slide, not to set off',
    watch:
      'Put down it stays, pushed downhill it never stops, and pushed uphill it stops once and stays.',
    experiments: [0, 1, -1].map((speed) => ({
      scene: 'ramp',
      parameters: { ...between, speed },
      duration: 3,
    })),
  },
  {
    id: 'edge-of-holding',
    group: 4,
    label: 'The edge of holding, for an hour',
    watch:
      'One is held for ever, the other, with friction less by 2 parts in 10¹², creeps 0.03 mm.',
    experiments: [edge(TAN_30 * (1 + 1e-12)), edge(TAN_30 * (1 - 1e-12))],
  },
  {
    id: 'like-glue',
    group: 5,
    label: 'Friction of 1000, frames of a second',
    watch: 'The block should stop within 1.4 mm: naive friction throws it kilometres away instead.',
    experiments: byRules(glue),
  },
  {
    id: 'vertical-wall',
    group: 6,
    label: 'A vertical ramp',
    watch: 'Nothing presses the block to the wall, so friction does nothing and makes no heat.',
    experiments: [
      {
        scene: 'ramp',
        parameters: { angle: 90, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
        duration: 2,
      },
      { scene: 'fall', parameters: { speed: -5 }, duration: 2 },
    ],
  },
  {
    id: 'level-ramp',
    group: 6,
    label: 'A level ramp without friction',
    watch:
      'Nothing acts along it: at rest it stays, and moving it keeps its speed to the last bit.',
    experiments: [0, 3].map((speed) => ({
      scene: 'ramp',
      parameters: { angle: 0, muStatic: 0, muKinetic: 0, speed },
      duration: 10,
    })),
  },
]

const stopping: Claims = {
  located: {
    what: 'Located stops, methods of second order and more: largest error at 1 to 1000 fps',
    why: 'a rounding of a position below 4 m in each of 640 steps',
    unit: 'm',
    rounding: true,
  },
  spread: {
    what: 'The same: frame-rate spread',
    why: 'the same roundings, of two runs',
    unit: 'm',
    rounding: true,
  },
  euler: {
    what: 'Located stops, the two Euler methods: off at the end',
    why: 'an exact stop at the end of an inexact path: ½ a T Δt, a step more or less',
    unit: 'm',
    failure: 'stops in the wrong place',
  },
  clamped: {
    what: 'Clamped stops: off at the end',
    why: 'the path of the last frame, and a first-order method’s own error',
    unit: 'm',
    failure: 'stops in the wrong place',
  },
  naive: {
    what: 'Naive stops: largest speed in the last second',
    why: 'a step over v = 0 ends on the other side of it',
    unit: 'm/s',
    failure: 'never rests',
  },
}

/** What holds of the cases of friction. */
export const frictionClaims: Readonly<Record<string, Claims>> = {
  'stops-on-the-flat': stopping,
  'stops-uphill': stopping,
  'comes-back': {
    located: {
      what: 'Located stops, methods of second order and more: largest error at 5 to 1000 fps',
      why: 'a rounding of a position below 8 m in each of 3000 steps',
      unit: 'm',
      rounding: true,
    },
    spread: {
      what: 'The same: frame-rate spread',
      why: 'the same roundings, of two runs',
      unit: 'm',
      rounding: true,
    },
    clamped: {
      what: 'Clamped stops at 30 fps: off at the end',
      why: 'a frame late at the final speed, and a first-order error on the way up and down',
      unit: 'm',
      failure: 'turns too late',
    },
  },
  'held-or-sliding': {
    held: {
      what: 'Put down, located or clamped stops: how far it moves',
      why: 'static friction holds it: no step is taken',
      unit: 'm',
    },
    sliding: {
      what: 'Pushed downhill, the same: smallest gain of speed in a frame',
      why: 'kinetic friction is less than gravity, and static friction has no say',
      unit: 'm/s',
    },
    stopped: {
      what: 'Pushed uphill, the same: speed at the end',
      why: 'a stop sets v to exactly 0, and static friction keeps it there',
      unit: 'm/s',
    },
    naive: {
      what: 'Put down, naive stops: how far it moves in 3 s',
      why: 'the paper’s formula knows no friction at rest',
      unit: 'm',
      failure: 'slides off',
    },
  },
  'edge-of-holding': {
    held: {
      what: 'Just held: how far it moves in an hour',
      why: 'no step is taken',
      unit: 'm',
    },
    freed: {
      what: 'Just not held: how far from ½ a t² it is after an hour',
      why: 'gravity and friction differ by 10⁻¹² of themselves, and are rounded',
      unit: 'm',
    },
    own: {
      what: 'The same, against the exact run of the rounded forces',
      why: '½ a T Δt of the two Euler methods; 216 000 roundings of the others',
      unit: 'm',
    },
  },
  'like-glue': {
    located: {
      what: 'Located stops, methods of second order and more: off at the end',
      why: 'some roundings of 1.4 mm',
      unit: 'm',
      rounding: true,
    },
    euler: {
      what: 'Located stops, the two Euler methods: off at the end',
      why: '½ a t² of the one step to the stop',
      unit: 'm',
      failure: 'stops in the wrong place',
    },
    clamped: {
      what: 'Clamped stops: distance at the end',
      why: 'it rests within the first frame: 1 s at 5 m/s',
      unit: 'm',
    },
    naive: {
      what: 'Naive stops: farthest distance',
      why: 'friction alone changes v by 9200 m/s in a step',
      unit: 'm',
      failure: 'is thrown away',
    },
  },
  'vertical-wall': {
    heat: {
      what: 'Heat, with any rule of stopping',
      why: 'cos 90° is exactly 0 here, and so is friction',
      unit: 'J',
    },
    fall: {
      what: 'Methods of second order and more: largest distance from the falling ball',
      why: 'roundings: the ramp’s step is cut where it turns',
      unit: 'm',
      rounding: true,
    },
    euler: {
      what: 'The two Euler methods: the same',
      why: 'the cut step is off by ½ g Δt² less',
      unit: 'm',
    },
  },
  'level-ramp': {
    speed: {
      what: 'Largest change of speed, with any rule of stopping',
      why: 'no force, no change: to the last bit',
      unit: 'm/s',
    },
    place: {
      what: 'Off at the end',
      why: '600 roundings of a position up to 30 m',
      unit: 'm',
      rounding: true,
    },
  },
}
