import type { NumberOption } from '../options.ts'
import { defineScene } from '../scene.ts'
import { straight } from '../track.ts'
import { angle, gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'

export const stiffness = {
  type: 'number',
  label: 'Stiffness',
  symbol: 'k',
  unit: 'N/m',
  min: 0,
  max: 1e12,
  slider: { from: 1, to: 4000, step: 1 },
  initial: 40,
  optional: true,
} as const satisfies NumberOption

/** A block on a slope, held by a spring that is slack at s = 0. */
export const spring = defineScene({
  id: 'spring',
  label: 'Spring',
  about:
    'A block on a spring on a slope: the stiffer it is, the smaller the step at which a method blows up.',
  parameters: { angle, stiffness, muStatic, muKinetic, gravity, mass, position, speed },
  duration: 4,
  facing: -1,
  track: ({ angle }) => [straight(angle!)],
})
