import { exactSpring } from '../exact/spring.ts'
import type { Law } from '../law.ts'
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
    const perMass = stiffness / mass
    const law = rubbing(mass, muStatic, muKinetic)
    return {
      ...law,
      forces: [{ drive: gravity * sin, perMetre: perMass, press: gravity * cos }],
      // At least a million times the energy it can have.
      speedLimit: perMass > 0 ? 1000 * fastest(parameters) : law.speedLimit,
    }
  },
  place: ({ angle }: SpringParameters, s: number) => placeOn([straight(angle)], s),
  potential: ({ angle, stiffness, gravity, mass }: SpringParameters, s: number) =>
    (0.5 * (stiffness / mass) * s - gravity * sinCosDegrees(angle).sin) * s,
  exact: exactSpring,
} as const satisfies Scene

/**
 * A speed that the block can't exceed [m/s]: that of its swing from where it begins about the point of balance, and its
 * own. The parts are added as if they never cancelled or squared, so that no rounding and no underflow makes it too
 * small for the motion.
 */
function fastest({ angle, stiffness, gravity, mass, position, speed }: SpringParameters): number {
  const omega = Math.sqrt(stiffness / mass)
  const balance = (gravity * sinCosDegrees(angle).sin) / omega
  return Math.abs(omega * position) + balance + Math.abs(speed)
}
