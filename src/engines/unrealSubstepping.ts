import type { Engine } from './engine.ts'

export const unrealSubstepping: Engine = {
  id: 'unreal-substepping',
  label: 'Unreal 5, substepping on',
  method: {
    timestep: { kind: 'substeps', step: 1 / 60, maxSteps: 6 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Cuts a frame into equal parts of at most 1/60 s (Max Substep Delta Time), at most 6 (Max Substeps); of longer frames the rest is dropped.',
  leavesOut: 'Left out: linear damping of 0.01/s.',
  safer: {
    how: 'Set Max Substep Delta Time to 1/120 s and Max Substeps to 16, the most it takes. Frames of up to 0.13 s then lose nothing, and the parts are shorter.',
    timestep: { kind: 'substeps', step: 1 / 120, maxSteps: 16 },
  },
  source: 'Unreal 5 as read in November 2026, PhysicsSettings.cpp and ChaosScene.cpp',
}
