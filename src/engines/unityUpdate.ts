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
  safer: {
    how: 'Move what slides to FixedUpdate: its steps are 0.02 s long (Fixed Timestep), whatever the frames are. Frames beyond Maximum Allowed Timestep still lose time.',
    timestep: { kind: 'fixed', step: 1 / 50, cap: 1 / 3, draw: 'latest' },
  },
  source: 'Unity manual 6000.3, Time.maximumDeltaTime; Unity blog of 1 October 2020',
}
