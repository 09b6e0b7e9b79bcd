import { readAddress } from '../state/address.ts'
import { preset } from './preset.ts'
import type { Preset } from './preset.ts'

const paper = 'semi-implicit-euler/clamped'
const blocks = `runners=10/${paper};30/${paper};120/${paper};30`
const gliding = 'angle=0&muStatic=0&muKinetic=0&speed=4&duration=2'
const latest = 'fixed(step:1/60,draw:latest)'
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
  'What the game takes for time': [
    [
      'Why does it stutter at a steady 60?',
      'Its timer counts whole milliseconds, so every frame is taken for 17 ms. The physics gains a third of a millisecond a frame, and every fiftieth frame takes two steps: the block jumps, and the game runs 2 % fast.',
      `${gliding}&runners=steady(fps:60,delta:rounded)/${latest};60/${latest}`,
    ],
    [
      'A smoothed delta',
      'Some frames miss a refresh. The block with the mean of the last ten falls behind each time and hurries after the other for ten frames: to a player both stutter.',
      `${gliding}&runners=missed-vsync(fps:60,seed:1,delta:mean);missed-vsync(fps:60,seed:1)`,
    ],
    [
      'Snapped to the wrong display',
      'Made for 60 Hz, where snapping mends every delta. At 75 Hz each frame is still taken for a sixtieth of a second, and the game runs 25 % fast.',
      `${gliding}&runners=steady(fps:75,delta:snapped);steady(fps:60,delta:snapped)`,
    ],
    [
      'One frame late',
      'The usual loop measures a frame when it is over. As long as frames are steady the block is one of them behind; when one misses a refresh, it is too far back in that frame and jumps in the next.',
      `${gliding}&runners=missed-vsync(fps:60,seed:1,delta:late);missed-vsync(fps:60,seed:1)`,
    ],
    [
      'Slow motion at a tenth',
      'At 0.1× only six of the fixed steps come in a second. Drawn at the latest step, the block moves in jerks; drawn between two steps, it glides.',
      `timeScale=0.1&duration=8&runners=60/${latest}/${paper};60/fixed(step:1/60)/${paper};60`,
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

/** Hilltops, belts, clocks and tolerances, as players meet them. */
export const situationPresets: readonly Preset[] = Object.entries(groups).flatMap(([group, rows]) =>
  rows.map(([label, watch, address]) => preset(group, label, watch, () => readAddress(address))),
)
