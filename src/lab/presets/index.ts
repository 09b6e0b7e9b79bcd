import { changed } from '../state/change.ts'
import type { ModeId } from '../state/modes.ts'
import { opening } from '../state/opening.ts'
import { figurePresets } from './figures.ts'
import { hardPresets } from './hardCases.ts'
import { preset } from './preset.ts'
import type { Preset } from './preset.ts'
import { situationPresets } from './situations.ts'

const kick = (label: string, mode: ModeId, watch: string): Preset =>
  preset('A kick up a ramp', label, watch, () =>
    // The lab opens in this mode.
    mode === 'clamped' ? opening : changed(opening, { kind: 'mode', mode }),
  )

/** The opening, and what each of its buttons makes of it. */
const kicks: readonly Preset[] = [
  kick(
    'Three frame rates, three stops',
    'clamped',
    'The fewer the frames, the earlier the block stops, and none of them stops where it should.',
  ),
  kick(
    'Without delta time',
    'no-delta-time',
    'Play it: at 120 fps the block races, and at 10 fps it crawls. After a second only the fast one is at rest.',
  ),
  kick(
    'The paper’s step',
    'paper',
    'Go on frame by frame when the blocks have stopped: they tremble on the spot.',
  ),
  kick(
    'A fixed step',
    'fixed-step',
    'All frame rates agree on one place, and it is 4 cm from the right one.',
  ),
  kick(
    'Located stops',
    'located',
    'Three blocks in one outline: type any frame rate, and nothing moves.',
  ),
  kick(
    'To a tolerance',
    'to-tolerance',
    'On a straight nothing is gained over located stops; go to the half-pipe or the spring, and the blocks stay together there too.',
  ),
]

/** Every preset, in the order of the menu. */
export const presets: readonly Preset[] = [
  ...kicks,
  ...situationPresets,
  ...figurePresets,
  ...hardPresets,
]
