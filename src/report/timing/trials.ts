import type { IntegratorId, SceneId } from '../../physics/index.ts'
import type { Amount } from './works.ts'

/** What is timed: ten seconds in steps so short that even explicit Euler stays in the half-pipe. */
export const timed: Amount = { runs: 5, steps: 10_000, step: 1 / 1000 }

const ground = { gravity: 9.81, mass: 1.5 }

/** A motion for each scene that steps are timed on: the block moves all the time. */
const parameters = {
  fall: { ...ground, drag: 0.02, position: 0, speed: 0 },
  ramp: { ...ground, angle: 30, muStatic: 0.3, muKinetic: 0.2, position: 0, speed: 0 },
  'run-out': {
    ...ground,
    ...{ angle: 40, length: 50, bendRadius: 150 },
    ...{ muStatic: 0.1, muKinetic: 0.05, position: 0, speed: 0 },
  },
  'half-pipe': {
    ...ground,
    ...{ radius: 2, muStatic: 0.002, muKinetic: 0.002, position: 1.6, speed: 0 },
  },
  spring: {
    ...ground,
    ...{ angle: 30, stiffness: 12, muStatic: 0.002, muKinetic: 0.002, position: -2, speed: 0 },
  },
} as const satisfies Partial<Record<SceneId, Record<string, number>>>

export type TimedScene = keyof typeof parameters

export const timedScenes = Object.keys(parameters) as TimedScene[]

/** The motion of a scene by a method, a step a frame. */
export function trial(scene: TimedScene, integrator: IntegratorId) {
  return {
    scene,
    parameters: parameters[scene],
    integrator,
    frames: { kind: 'steady', fps: 1 / timed.step },
    duration: timed.steps * timed.step,
  } as const
}
