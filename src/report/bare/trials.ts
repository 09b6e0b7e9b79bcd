import type { Trial } from './bareLoop.ts'

const ground = { gravity: 9.81, mass: 1.5 }

/** What is timed: in each scene a block that moves all the time, and wherever there is friction one that stops on its way. */
export const trials: readonly Trial[] = [
  {
    scene: 'fall',
    kind: 'moves',
    parameters: { ...ground, drag: 0.02, position: 0, speed: 0 },
    fps: 1000,
    steps: 10000,
  },
  {
    scene: 'ramp',
    kind: 'moves',
    parameters: { ...ground, angle: 30, muStatic: 0.3, muKinetic: 0.2, position: 0, speed: 0 },
    fps: 1000,
    steps: 10000,
  },
  {
    scene: 'ramp',
    kind: 'stops',
    parameters: { ...ground, angle: 1, muStatic: 0.1, muKinetic: 0.05, position: 0, speed: -6 },
    fps: 1000,
    steps: 10000,
  },
  {
    scene: 'run-out',
    kind: 'moves',
    parameters: {
      ...ground,
      ...{ angle: 40, length: 50, bendRadius: 150 },
      ...{ muStatic: 0.1, muKinetic: 0.05, position: 0, speed: 0 },
    },
    fps: 1000,
    steps: 10000,
  },
  {
    scene: 'run-out',
    kind: 'stops',
    parameters: {
      ...ground,
      ...{ angle: 20, length: 15, bendRadius: 20 },
      ...{ muStatic: 0.2, muKinetic: 0.15, position: 0, speed: 1 },
    },
    fps: 1000,
    steps: 10000,
  },
  {
    scene: 'half-pipe',
    kind: 'moves',
    parameters: {
      ...ground,
      ...{ radius: 2, muStatic: 0.002, muKinetic: 0.002, position: 1.6, speed: 0 },
    },
    fps: 1000,
    steps: 10000,
  },
  {
    scene: 'half-pipe',
    kind: 'stops',
    parameters: {
      ...ground,
      ...{ radius: 2, muStatic: 0.15, muKinetic: 0.12, position: 1.6, speed: 0 },
    },
    fps: 1000,
    steps: 10000,
  },
  {
    scene: 'spring',
    kind: 'moves',
    parameters: {
      ...ground,
      ...{ angle: 30, stiffness: 12, muStatic: 0.002, muKinetic: 0.002, position: -2, speed: 0 },
    },
    fps: 1000,
    steps: 10000,
  },
  {
    scene: 'spring',
    kind: 'stops',
    parameters: {
      ...ground,
      ...{ angle: 30, stiffness: 12, muStatic: 0.25, muKinetic: 0.2, position: -2, speed: 0 },
    },
    fps: 1000,
    steps: 10000,
  },
]
