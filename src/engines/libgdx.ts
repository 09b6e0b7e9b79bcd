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
  safer: {
    how: 'In that loop, make the step 1/120 s, and the bound on a frame 1 s instead of 0.25 s as long as 120 steps take less time than that. Frames of up to a second then lose nothing, and the error is about half.',
    timestep: { kind: 'fixed', step: 1 / 120, cap: 1, draw: 'latest' },
  },
  source: 'libGDX wiki as read in November 2026, box2d.md',
}
