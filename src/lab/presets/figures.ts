import { readAddress } from '../state/address.ts'
import { preset } from './preset.ts'
import type { Preset } from './preset.ts'

/* What the figures of the tutorial run as they open, as far as a lab can show it. A test holds them to the figures. */

const times = (count: number, frame: string) => Array.from({ length: count }, () => frame)
const hitch = `recorded(durations:${[...times(18, '1/60'), '0.25', ...times(84, '1/60')].join('+')})`
const busy = `recorded(durations:4n-m9_99m22_99m8_DWm13_99m22_99m22_DWm22_99m22_99m13_DWm8_99m22_99m22_99m4_DWm17_99)`
const paper = 'semi-implicit-euler/clamped'

/** The id of the figure, its name in the menu, what to watch, and the lab's address. */
const rows: readonly (readonly [id: string, label: string, watch: string, address: string])[] = [
  [
    'falling-ball',
    'A ball without delta time',
    'At 15 fps the ball falls as if time went four times as slow; choose “variable” as its time step.',
    'scene=fall&drag=0&duration=1&runners=15/per-frame(step:1/60)/semi-implicit-euler',
  ],
  [
    'forces-on-slope',
    'Three forces on a slope',
    'Show the forces and tilt the track: the normal force shrinks as it gets steeper, and friction with it.',
    'angle=30&muStatic=0.3&muKinetic=0.3&mass=2&speed=2&runners=60',
  ],
  [
    'mass-cancels',
    'A light block and a heavy one',
    'Change the mass: no block moves, although every force does.',
    'angle=20&muStatic=0.15&muKinetic=0.15&speed=0&duration=1.5&runners=60',
  ],
  [
    'critical-angle',
    'Until it slides',
    'Tilt the track until the block sets off: at atan 0.45, which is 24.2°.',
    'angle=10&muStatic=0.45&muKinetic=0.36&speed=0&duration=0.6&runners=60',
  ],
  [
    'two-become-one',
    'Two dimensions become one',
    'Show the forces: gravity’s part across the slope is as long as the normal force, and against it.',
    'angle=25&muStatic=0.2&muKinetic=0.2&speed=1&runners=60',
  ],
  [
    'area-under-v',
    'Bars under the speed',
    'The block ends ½ a T Δt too far; with explicit Euler it ends as much too near.',
    'angle=30&muStatic=0.2&muKinetic=0.2&speed=0&duration=2&runners=2.5/semi-implicit-euler',
  ],
  [
    'where-does-it-stop',
    'The bet',
    'One block is right, and three stop before it, each at a place of its own.',
    `angle=10&muStatic=0.4&muKinetic=0.4&speed=-7&duration=1.6&runners=60;10/${paper};30/${paper};120/${paper}`,
  ],
  [
    'chatter',
    'Chatter',
    'Look at the plot of the speed from 0.69 s on: it jumps over 0 and back, for ever.',
    'duration=1.5&runners=30/semi-implicit-euler/naive',
  ],
  [
    'three-stops',
    'Three stops',
    'The blocks end 0.23 m apart; press “Located”, and they don’t.',
    '',
  ],
  [
    'frames-and-ticks',
    'Frames and steps',
    'In the strip under the time: frames above, steps below, and the accumulator filling up between them.',
    'muStatic=0.3&muKinetic=0.3&duration=0.6&runners=24/fixed(step:0.05)',
  ],
  [
    'hitch',
    'One long frame',
    'Four ways through the same hitch: the variable step stops far off, the capped one loses 0.2 s.',
    `duration=1.4&runners=${hitch}/${paper};${hitch}/capped(cap:0.05)/${paper};${hitch}/substeps(step:1/60)/${paper};${hitch}/fixed(step:1/60,maxSteps:60)/${paper}`,
  ],
  [
    'your-frames',
    'Frames of a busy browser',
    'Compare the errors; then record your own frames for a runner.',
    `runners=${busy}/${paper};${busy}/capped(cap:1/60)/${paper};${busy}/fixed(step:1/60)/${paper};${busy}`,
  ],
  [
    'your-engine',
    'Three players, one engine',
    'Choose your own engine in the menu beside this one, and read what it does with these frames.',
    `duration=1.5&runners=${['20', '60', '144'].map((fps) => `${fps}/capped(cap:1/3)/${paper}`).join(';')}`,
  ],
  [
    'half-pipe-energy',
    'Energy in a half-pipe',
    'In the plot of the energy, explicit Euler climbs until its block is out; the others stay level.',
    'scene=half-pipe&position=2.2&duration=10&runners=20/explicit-euler;20/semi-implicit-euler;20;20/rk4',
  ],
  [
    'spring-limit',
    'A stiff spring',
    'ωΔt is 1.5 here. Raise the stiffness to 1610 N/m, beyond ωΔt = 2, and the block is gone.',
    'scene=spring&angle=0&stiffness=900&muStatic=0&muKinetic=0&position=1&duration=3&runners=20',
  ],
  [
    'flung-out',
    'Thrown out of the pipe',
    'Play it: the block swings higher each time, until it flies over the edge.',
    'scene=half-pipe&position=2.6&duration=12&runners=60/explicit-euler',
  ],
  [
    'step-to-tolerance',
    'Steps to tolerance',
    'In the strip under the time: steps crowd where the ball is quick.',
    'scene=fall&drag=2&speed=12&position=0&duration=2&runners=1/tolerance(tolerance:0.0001)/rk4',
  ],
  [
    'break-it',
    'Try to break it',
    'Change the frame rates, the scatter and the stalls as you like: the blocks end in one place.',
    'duration=2&runners=15;jitter(fps:15,amount:0.6,seed:1);hitch(fps:15,every:0.3,length:0.25)',
  ],
]

/** Every figure of the tutorial that a lab can show, by its name. */
export const figurePresets: readonly (Preset & { readonly figure: string })[] = rows.map(
  ([figure, label, watch, address]) => {
    const made = preset('Figures of the tutorial', label, watch, () => readAddress(address))
    return Object.assign(made, { figure })
  },
)
