import type { HardCase, Claims } from './hardCase.ts'

const level = { angle: 0, muStatic: 0.5, muKinetic: 0.5, gravity: 10, speed: 5 }
const hill = {
  angle: 30,
  length: 0.2,
  bendRadius: 0.5,
  muStatic: 0.6,
  muKinetic: 0.6,
  speed: 2,
}
/** Runs down 30° against μ = 1: a = g (sin 30° − cos 30°), from 3 m/s to rest in v²/(2 |a|). */
const braking = 9.81 * (Math.sqrt(0.75) - 0.5)

/** Instants at which the law jumps, where they are hardest to tell apart. */
export const jumps: readonly HardCase[] = [
  {
    id: 'joint-and-stop-in-a-step',
    group: 14,
    label: 'A joint and a stop in one step',
    watch: 'A frame of a second holds both ends of the bend and the stop on the flat behind it.',
    experiments: [1, 10, 100].map((fps) => ({
      scene: 'run-out',
      parameters: hill,
      integrator: 'rk4',
      frames: { kind: 'steady', fps },
      duration: 3,
    })),
  },
  {
    id: 'joints-of-no-bend',
    group: 14,
    label: 'Two joints at one place, and a stop',
    watch: 'A bend of no angle has both its ends at one place: passing it changes nothing.',
    experiments: [1, 60].map((fps) => ({
      scene: 'run-out',
      parameters: { ...level, length: 2.4 },
      frames: { kind: 'steady', fps },
      duration: 2,
    })),
  },
  {
    id: 'stop-at-a-frames-end',
    group: 15,
    label: 'A stop exactly at a frame’s end',
    watch:
      'The last frame ends with v = 0 to the bit: the block rests from there, neither a frame late nor for a moment only.',
    experiments: [10, 64].map((fps) => ({
      scene: 'ramp',
      parameters: level,
      frames: { kind: 'steady', fps },
      duration: 2,
    })),
  },
  {
    id: 'stop-at-a-joint',
    group: 15,
    label: 'A stop exactly at a joint',
    watch: 'The slope ends where the block does: it stays there, on one side or the other.',
    experiments: [5, 60].map((fps) => ({
      scene: 'run-out',
      parameters: {
        angle: 30,
        length: 9 / (2 * braking),
        muStatic: 1,
        muKinetic: 1,
        speed: 3,
      },
      frames: { kind: 'steady', fps },
      duration: 3,
    })),
  },
  {
    id: 'joint-at-a-frames-end',
    group: 15,
    label: 'A joint exactly at a frame’s end',
    watch: 'A frame ends where the slope does: the next begins on the bend.',
    experiments: [
      {
        scene: 'run-out',
        parameters: { angle: 0, length: 2, muStatic: 0, muKinetic: 0, speed: 1 },
        frames: { kind: 'steady', fps: 4 },
        duration: 4,
      },
    ],
  },
]

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
