import { exactTrack } from '../exact/track.ts'
import type { Law } from '../law.ts'
import type { Values } from '../options.ts'
import type { Scene } from '../scene.ts'
import { placeOn, straight } from '../track.ts'
import { sinCosDegrees } from '../trigonometry.ts'
import { rubbing } from './law.ts'
import { angle, gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'

const parameters = { angle, muStatic, muKinetic, gravity, mass, position, speed } as const
type RampParameters = Values<typeof parameters>

/** The paper's character: a block on a straight slope, with friction. */
export const ramp = {
  id: 'ramp',
  label: 'Ramp',
  about: 'A block on a slope with friction: it slides, stops, stays, or comes back.',
  parameters,
  duration: 2,
  facing: -1,
  law: ({ angle, muStatic, muKinetic, gravity, mass }: RampParameters): Law => {
    const { sin, cos } = sinCosDegrees(angle)
    return {
      ...rubbing(mass, muStatic, muKinetic),
      // #region forces
      forces: [{ drive: gravity * sin, press: gravity * cos }],
      // #endregion
    }
  },
  place: ({ angle }: RampParameters, s: number) => placeOn([straight(angle)], s),
  potential: ({ angle, gravity }: RampParameters, s: number) =>
    -gravity * sinCosDegrees(angle).sin * s,
  exact: (parameters: RampParameters) => exactTrack([straight(parameters.angle)], parameters),
} as const satisfies Scene
