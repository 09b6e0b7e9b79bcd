import { withoutRounding } from '../../measure/index.ts'
import { forcesAt, length } from '../../physics/index.ts'
import type { Experiment } from '../../physics/index.ts'
import { fixed, metres } from '../../chart/numbers.ts'
import { end } from './experiments.ts'
import type { Facts } from './fact.ts'

const newtons = (value: number) => `${fixed(value, 2)}\u202fN`
// The block of the figure.
const forces = (angle: number) =>
  forcesAt({ scene: 'ramp', parameters: { angle, mass: 2 } }, { s: 0, v: 1 })
const heavy = (mass: number): Experiment => ({
  scene: 'ramp',
  parameters: { angle: 20, muStatic: 0.15, muKinetic: 0.15, mass },
  duration: 1.5,
})

/** What a ramp carries of a block, and what its mass changes. */
export const forcesOnASlope = {
  weight: { value: () => length(forces(30).gravity), show: newtons },
  normal30: { value: () => length(forces(30).normal), show: newtons },
  normal60: { value: () => length(forces(60).normal), show: newtons },
  massApart: {
    // The way is some metres long.
    value: () => withoutRounding(Math.abs(end(heavy(50)) - end(heavy(1))), 1),
    show: metres,
  },
} as const satisfies Facts
