import type { Engine } from './engine.ts'

export const unreal: Engine = {
  id: 'unreal',
  label: 'Unreal 5',
  method: {
    timestep: { kind: 'capped', cap: 1 / 30 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'One step a frame, at most 1/30 s for physics (Max Physics Delta Time); the rest is dropped. Substepping is off.',
  leavesOut: 'Left out: linear damping of 0.01/s, and game code, whose delta is not capped.',
  safer: {
    how: 'Switch Substepping on, with a Max Substep Delta Time of 1/60 s and 16 Max Substeps, the most it takes. Frames of up to 0.27 s then lose nothing. The parts still follow the frames, so players stay a little apart.',
    timestep: { kind: 'substeps', step: 1 / 60, maxSteps: 16 },
  },
  source:
    'Unreal 5 as read in November 2026, PhysicsSettings.cpp, ChaosScene.cpp and PBDRigidsEvolutionGBF.cpp',
}
