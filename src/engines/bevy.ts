import type { Engine } from './engine.ts'

export const bevy: Engine = {
  id: 'bevy',
  label: 'Bevy, FixedUpdate',
  method: {
    timestep: {
      kind: 'fixed',
      step: 1 / 64,
      cap: 0.25,
      draw: 'latest',
    },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'FixedUpdate runs 64 times a second. A frame counts for 0.25 s at most; the rest is dropped. The last step is drawn.',
  leavesOut:
    'Left out: nothing of the loop. Bevy has no physics of its own; method and stops are those of the paper, clamped.',
  safer: {
    how: 'Insert Time::<Fixed>::from_hz(128.0), and call set_max_delta of Time<Virtual> with 1 s as long as 128 steps take less time than that. Frames of up to a second then lose nothing, and the error is about half.',
    timestep: { kind: 'fixed', step: 1 / 128, cap: 1, draw: 'latest' },
  },
  source: 'bevy_time as read in November 2026, fixed.rs and virt.rs',
}
