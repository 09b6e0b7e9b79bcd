import type { Engine } from './engine.ts'

export const unityFixedUpdate: Engine = {
  id: 'unity-fixed-update',
  label: 'Unity, FixedUpdate',
  method: {
    timestep: {
      kind: 'fixed',
      step: 1 / 50,
      cap: 1 / 3,
      draw: 'latest',
    },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Physics takes steps of 0.02 s (Fixed Timestep). A frame counts for 1/3 s at most (Maximum Allowed Timestep); the rest is dropped. Interpolation is off, so the last step is drawn.',
  leavesOut:
    'Left out: damping, which in three dimensions multiplies by 1 − k Δt and in two by 1/(1 + k Δt). Projects set both times, some to 0.1 s.',
  safer: {
    how: 'Set Fixed Timestep to 0.01 s, and Maximum Allowed Timestep to 1 s as long as 100 steps take less time than that. Frames of up to a second then lose nothing, and the error is about half.',
    timestep: { kind: 'fixed', step: 1 / 100, cap: 1, draw: 'latest' },
  },
  source:
    'Unity manual 6000.3, Time.maximumDeltaTime and Rigidbody2D.linearDamping; PhysX, DyBodyCoreIntegrator.h',
}
