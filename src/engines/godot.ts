import type { Engine } from './engine.ts'

export const godot: Engine = {
  id: 'godot',
  label: 'Godot 4',
  method: {
    timestep: { kind: 'fixed', step: 1 / 60, maxSteps: 8, draw: 'latest' },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Physics takes 60 steps a second (Physics Ticks per Second), at most 8 in a frame (Max Physics Steps per Frame); what exceeds them is dropped. Interpolation is off.',
  leavesOut:
    'Left out: the jitter fix, which moves a step to a neighbouring frame, and the default damping of 0.1/s.',
  safer: {
    how: 'Set Physics Ticks per Second to 120, and Max Physics Steps per Frame to 120 as long as 120 steps take less than a second. Frames of up to a second then lose nothing, and the error is about half.',
    timestep: { kind: 'fixed', step: 1 / 120, maxSteps: 120, draw: 'latest' },
  },
  source: 'Godot 4 as read in November 2026, main_timer_sync.cpp, engine.h and godot_body_2d.cpp',
}
