import { exactSpring } from '../exact/spring.ts'
import type { Law, Motion } from '../motion.ts'
import type { NumberOption, Values } from '../options.ts'
import type { Scene } from '../scene.ts'
import { placeOn, straight } from '../track.ts'
import { sinCosDegrees } from '../trigonometry.ts'
import { rubbing } from './law.ts'
import { angle, gravity, mass, muKinetic, muStatic, position, speed } from './parameters.ts'

const stiffness = {
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

const parameters = {
  angle,
  stiffness,
  muStatic,
  muKinetic,
  gravity,
  mass,
  position,
  speed,
} as const
type SpringParameters = Values<typeof parameters>

/** A block on a slope, held by a spring that is slack at s = 0. */
export const spring = {
  id: 'spring',
  label: 'Spring',
  about:
    'A block on a slope, held by a spring: the stiffer it is, the smaller the step at which a method blows up.',
  parameters,
  duration: 4,
  facing: -1,
  law: (parameters: SpringParameters): Law => {
    const { angle, stiffness, muStatic, muKinetic, gravity, mass } = parameters
    const { sin, cos } = sinCosDegrees(angle)
    const weight = gravity * sin
    const perMass = stiffness / mass
    const press = gravity * cos
    const law = rubbing(mass, muStatic, muKinetic)
    return {
      ...law,
      // #region forces
      forces: (motion: Motion) => {
        motion.drive = weight - perMass * motion.s
        motion.press = press
      },
      // #endregion
      // A million times the energy it can have.
      speedLimit: stiffness > 0 ? 1000 * fastest(parameters) : law.speedLimit,
    }
  },
  place: ({ angle }: SpringParameters, s: number) => placeOn([straight(angle)], s),
  potential: ({ angle, stiffness, gravity, mass }: SpringParameters, s: number) =>
    (0.5 * (stiffness / mass) * s - gravity * sinCosDegrees(angle).sin) * s,
  exact: exactSpring,
} as const satisfies Scene

/** The speed that the block can't exceed: all its energy, seen from the point of balance, as motion [m/s]. */
function fastest({ angle, stiffness, gravity, mass, position, speed }: SpringParameters): number {
  const omega = Math.sqrt(stiffness / mass)
  const fromBalance = omega * position - (gravity * sinCosDegrees(angle).sin) / omega
  return Math.sqrt(fromBalance * fromBalance + speed * speed)
}
