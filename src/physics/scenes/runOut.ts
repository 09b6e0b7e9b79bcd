import type { NumberOption } from '../options.ts'
import { defineScene } from '../scene.ts'
import { arcAfter, straight, straightAfter } from '../track.ts'
import { radians } from '../trigonometry.ts'
import { angle, gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'

const length = {
  type: 'number',
  label: 'Length of the slope',
  symbol: 'L',
  unit: 'm',
  min: 0,
  max: 1e6,
  slider: { from: 0, to: 10, step: 0.1 },
  initial: 4,
  optional: true,
} as const satisfies NumberOption

const bendRadius = {
  type: 'number',
  label: 'Radius of the bend',
  symbol: 'R',
  unit: 'm',
  min: 0.001,
  max: 1e6,
  slider: { from: 0.2, to: 5, step: 0.1 },
  initial: 1.5,
  optional: true,
} as const satisfies NumberOption

/** Down a slope, round a bend and out onto the flat. */
export const runOut = defineScene({
  id: 'run-out',
  label: 'Run-out',
  about: 'Down a hill, round a bend and out on the flat: where does it stop?',
  parameters: {
    ...{ angle, length, bendRadius, muStatic, muKinetic },
    ...{ gravity, mass, position, speed },
  },
  duration: 4,
  facing: 1,
  track: ({ angle, length, bendRadius }) => {
    const hill = straight(angle!, length)
    const bend = arcAfter(hill, 1 / bendRadius!, length! + bendRadius! * radians(angle!))
    return [hill, bend, straightAfter(bend, 0)]
  },
})
