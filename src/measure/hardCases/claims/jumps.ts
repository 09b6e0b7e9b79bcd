import type { Claims } from '../claim.ts'

/** What holds of the cases of stops and joints. */
export const jumpsClaims: Readonly<Record<string, Claims>> = {
  'joint-and-stop-in-a-step': {
    found: {
      what: 'Jumps found inside the one step',
      why: 'both ends of the bend, and the stop',
      unit: 'things',
    },
    error: {
      what: 'Off at the end, at 1, 10 and 100 fps',
      why: 'by the method’s order, of how much the law changes along the bend in a step',
      unit: 'm',
    },
    speed: {
      what: 'Speed at the end',
      why: 'a stop sets v to exactly 0',
      unit: 'm/s',
    },
  },
  'joints-of-no-bend': {
    place: {
      what: 'Methods of second order and more: off from 2.5 m',
      why: 'some roundings in each of 60 steps',
      unit: 'm',
      rounding: true,
    },
    time: {
      what: 'The same: instant of the stop, off from 1 s',
      why: 'the same',
      unit: 's',
      rounding: true,
    },
  },
  'stop-at-a-frames-end': {
    place: {
      what: 'Methods of second order and more: off from 2.5 m',
      why: 'a rounding a frame',
      unit: 'm',
      rounding: true,
    },
    time: {
      what: 'The same: instant of the stop, off from 1 s',
      why: 'a rounding a frame',
      unit: 's',
      rounding: true,
    },
    speed: {
      what: 'Velocity Verlet at 64 fps, located or clamped stops: speed after 1 s',
      why: 'there 5 m/s less 64 times 5/64 m/s is not rounded',
      unit: 'm/s',
    },
  },
  'stop-at-a-joint': {
    place: {
      what: 'Methods of second order and more: distance from the joint',
      why: 'the roundings of fifty steps',
      unit: 'm',
      rounding: true,
    },
    creep: {
      what: 'The same: how far it moves after the stop',
      why: 'at rest no step is taken',
      unit: 'm',
    },
  },
  'joint-at-a-frames-end': {
    speed: {
      what: 'Largest change of speed, with any rule of stopping',
      why: 'no force, no change: to the last bit',
      unit: 'm/s',
    },
    place: {
      what: 'Largest error',
      why: '16 roundings of a position up to 4 m',
      unit: 'm',
      rounding: true,
    },
  },
}
