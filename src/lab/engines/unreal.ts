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
  source:
    'Unreal 5 as read in November 2026, PhysicsSettings.cpp, ChaosScene.cpp and PBDRigidsEvolutionGBF.cpp',
}
