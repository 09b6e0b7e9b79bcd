import { readAddress } from '../state/address.ts'
import { preset } from './preset.ts'
import type { Preset } from './preset.ts'

const paper = 'semi-implicit-euler/clamped'
const blocks = `runners=10/${paper};30/${paper};120/${paper};30`
const exactly = 'tolerance(tolerance:1e-6)/rk4'

/** What a player would call it, what to watch, and the lab's address, by the group of the menu. */
const groups: Readonly<Record<string, readonly (readonly [string, string, string])[]>> = {
  'Over a hilltop': [
    [
      'Just fast enough to take off',
      'The true block takes off where the top begins. At 10 fps the same jump never happens, because no frame falls on the moment when it should.',
      `scene=crest&speed=6.9&duration=1.5&${blocks}`,
    ],
    [
      'Just too slow to take off',
      'A little slower, and every block stays on the ground. In the plot of the press, the true one comes within a few percent of 0.',
      `scene=crest&speed=6.6&duration=1.5&${blocks}`,
    ],
    [
      'Fast enough by far',
      'All of them take off, and each at its next frame: at 10 fps up to a tenth of a second late, and that much further up the hill.',
      `scene=crest&speed=9&duration=1&${blocks}`,
    ],
    [
      'Off a smooth dome',
      'A block that starts almost at rest on the top leaves the dome at 48.2°, where the cosine is ⅔, whatever the radius and the gravity.',
      'scene=crest&angle=75&muStatic=0&muKinetic=0&position=3.93&speed=0.05&duration=3&runners=10/semi-implicit-euler/clamped;120/semi-implicit-euler/clamped;30/tolerance(tolerance:1e-6)/rk4',
    ],
  ],
  'On a moving platform': [
    [
      'Why does my platform shake its passengers?',
      'Because at rest means at the platform’s speed, not at 0. The naive block is dragged along in jerks that no spring makes; with located stops it rides until the spring tears it off.',
      'scene=belt&duration=4&runners=30/semi-implicit-euler/naive;30',
    ],
    [
      'It rides, it slips, it sticks again',
      'In the plot of speed over position each round has a flat side: there the block moves as fast as the belt, to the last digit.',
      `scene=belt&stiffness=20&muStatic=0.6&muKinetic=0.2&duration=5&runners=10/${paper};120/${paper};30/${exactly}`,
    ],
  ],
  'To a tolerance': [
    [
      'Three frame rates in a half-pipe',
      'After six seconds the blocks are within a micrometre of each other. In the strip under the time their steps crowd where they are quick.',
      `scene=half-pipe&position=2.8&duration=6&runners=10/${exactly};30/${exactly};120/${exactly}`,
    ],
    [
      'A tolerance that can’t be met',
      'Under the naive rule the force at rest jumps at every step, however short. No step is short enough, and the run says so and ends.',
      'duration=1&runners=30/tolerance(tolerance:1e-6)/rk4/naive;30/tolerance(tolerance:1e-6)/rk4',
    ],
  ],
}

/** Hilltops, belts and tolerances, as players meet them. */
export const situationPresets: readonly Preset[] = Object.entries(groups).flatMap(([group, rows]) =>
  rows.map(([label, watch, address]) => preset(group, label, watch, () => readAddress(address))),
)
