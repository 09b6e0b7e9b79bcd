import type { NumberOption } from '../options.ts'
import { defineScene } from '../scene.ts'
import { straight } from '../track.ts'
import { gravity, mass, position, speed } from './parameters.ts'

const drag = {
  type: 'number',
  label: 'Drag',
  symbol: 'c',
  unit: 'kg/m',
  min: 0,
  max: 1e6,
  slider: { from: 0, to: 2, step: 0.01 },
  initial: 0,
  optional: true,
} as const satisfies NumberOption

/** The paper's ball: it falls, with air drag if there is any. */
export const fall = defineScene({
  id: 'fall',
  label: 'Fall',
  about: 'A ball falls: the simplest motion. With drag the force depends on the speed.',
  parameters: { gravity, mass, drag, position, speed },
  duration: 2,
  facing: 1,
  track: () => [straight(90)],
})
