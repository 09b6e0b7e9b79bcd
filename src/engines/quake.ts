import { ownLoop } from './engine.ts'
import type { Engine } from './engine.ts'

export const quake: Engine = {
  id: 'quake',
  label: 'Quake',
  method: {
    timestep: { kind: 'capped', cap: 0.1 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'One step a frame, at most 0.1 s; the rest is dropped.',
  leavesOut: 'Left out: no more than 72 frames a second, and friction that grows with the speed.',
  safer: ownLoop('move the player'),
  source: 'Quake as read in November 2026, host.c, sv_phys.c and sv_user.c',
}
