import type { Engine } from './engine.ts'

export const libgdx: Engine = {
  id: 'libgdx',
  label: 'libGDX, the loop of its wiki',
  method: {
    timestep: {
      kind: 'fixed',
      step: 1 / 60,
      cap: 0.25,
      draw: 'latest',
    },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Box2D takes steps of 1/60 s. A frame counts for 0.25 s at most; the rest is dropped, and the last step is drawn.',
  leavesOut: 'Left out: damping by 1/(1 + k Δt), which is 0 unless you set it.',
  source: 'libGDX wiki as read in November 2026, box2d.md',
}
