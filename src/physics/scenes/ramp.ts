import { defineScene } from '../scene.ts'
import { straight } from '../track.ts'
import { angle, gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'

/** The paper's character: a block on a straight slope, with friction. */
export const ramp = defineScene({
  id: 'ramp',
  label: 'Ramp',
  about: 'A block on a slope with friction: it slides, stops, stays, or comes back.',
  parameters: { angle, muStatic, muKinetic, gravity, mass, position, speed },
  duration: 2,
  facing: -1,
  track: ({ angle }) => [straight(angle!)],
})
