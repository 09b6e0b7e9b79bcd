import type { Claims } from '../claim.ts'

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
