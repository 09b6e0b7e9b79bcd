import type { HardCase } from './hardCase.ts'

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
