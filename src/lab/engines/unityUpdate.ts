import type { Engine } from './engine.ts'

export const unityUpdate: Engine = {
  id: 'unity-update',
  label: 'Unity, Update',
  method: {
    timestep: { kind: 'capped', cap: 1 / 3 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Your own code takes a step of deltaTime, which is 1/3 s at most (Maximum Allowed Timestep); the rest is dropped.',
  leavesOut:
    'Left out: deltaTime is smoothed since 2020.2. Method and stops are yours; here they are those of the paper, clamped.',
  source: 'Unity manual 6000.3, Time.maximumDeltaTime; Unity blog of 1 October 2020',
}
