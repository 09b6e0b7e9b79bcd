import type { NumberOption } from '../options.ts'
import { defineScene } from '../scene.ts'
import { arcAfter, straight, straightAfter } from '../track.ts'
import { radians } from '../trigonometry.ts'
import { angle, gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'

const crestRadius = {
  type: 'number',
  label: 'Radius of the crest',
  symbol: 'R',
  unit: 'm',
  min: 0.001,
  max: 1e6,
  slider: { from: 0.5, to: 10, step: 0.1 },
  initial: 3,
  optional: true,
} as const satisfies NumberOption

/** Up a hill, over its rounded top and down the other side. */
export const crest = defineScene({
  id: 'crest',
  label: 'Crest',
  about: 'Over a hilltop: too slow and it comes back, too fast and it takes off.',
  parameters: {
    angle: { ...angle, initial: 20 },
    crestRadius,
    muStatic: { ...muStatic, initial: 0.1 },
    muKinetic: { ...muKinetic, initial: 0.1 },
    ...{ gravity, mass, position: { ...position, initial: -2 }, speed: { ...speed, initial: 6 } },
  },
  duration: 3,
  facing: 1,
  track: ({ angle, crestRadius }) => {
    const up = straight(-angle!, 0)
    const top = arcAfter(up, -1 / crestRadius!, 2 * crestRadius! * radians(angle!))
    return [up, top, straightAfter(top, angle!)]
  },
})
