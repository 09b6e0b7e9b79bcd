import type { NumberOption } from '../options.ts'
import { defineScene } from '../scene.ts'
import { straight } from '../track.ts'
import { gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'
import { stiffness } from './spring.ts'

// A block that starts at rest must be able to stick: friction alone makes it no faster than μk g √(m/k) = 0.465 m/s.
// On a faster belt it never would.
const beltSpeed = {
  type: 'number',
  label: 'Speed of the belt',
  symbol: 'u',
  unit: 'm/s',
  min: -1e9,
  max: 1e9,
  slider: { from: -2, to: 2, step: 0.01 },
  initial: 0.4,
  optional: true,
} as const satisfies NumberOption

/** On a moving belt, held by a spring that is slack at s = 0: it rides, slips back, and sticks again. */
export const belt = defineScene({
  id: 'belt',
  label: 'Belt',
  about:
    'A spring holds a block on a moving belt: it rides along until torn off, slips back, and sticks again.',
  parameters: {
    ...{ beltSpeed, stiffness, muStatic: { ...muStatic, initial: 0.5 } },
    ...{ muKinetic: { ...muKinetic, initial: 0.3 }, gravity, mass, position, speed },
  },
  duration: 4,
  facing: 1,
  track: () => [straight(0)],
})
