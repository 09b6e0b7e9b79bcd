import { dot, length, plus, times, zero } from './vector.ts'
import type { Vector } from './vector.ts'

/** The paper's character: a point with a velocity. */
export interface PaperBody {
  /** Position [m] and velocity [m/s]. */
  r: Vector
  v: Vector
}

/** The surface that the character slides on, and gravity. */
export interface Surface {
  /** Gravitational acceleration [m/s²]. */
  g: Vector
  /** The unit vector out of the surface. */
  n: Vector
  mass: number
  muKinetic: number
  muStatic: number
}

/** Which corrections are switched on. */
export interface Corrections {
  normalIsVector: boolean
  unitSlipDirection: boolean
  normalInSum: boolean
  staticFriction: boolean
  newVelocity: boolean
}

export const asPrinted: Corrections = {
  normalIsVector: false,
  unitSlipDirection: false,
  normalInSum: false,
  staticFriction: false,
  newVelocity: true,
}

export const allCorrected: Corrections = {
  normalIsVector: true,
  unitSlipDirection: true,
  normalInSum: true,
  staticFriction: true,
  newVelocity: true,
}

/**
 * One step of the paper (Åsbø, An introduction to framerate-independent game physics, 2022, section III), as it is
 * printed wherever a correction is off. `newVelocity` off takes the paper at its word “forward Euler”; its formula
 * uses the new velocity. Where a number is added to a vector, it is added to both components, as shading languages do.
 * Returns a new body; the given one is not changed.
 */
// #region step
export function paperStep(
  body: PaperBody,
  surface: Surface,
  dt: number,
  corrections: Corrections,
): PaperBody {
  const { r, v } = body
  const { g, n, mass, muKinetic, muStatic } = surface
  const press = -mass * dot(g, n)
  const normal = corrections.normalIsVector ? times(press, n) : { x: press, y: press }
  const sliding = plus(v, times(-dot(n, v), n))
  const speed = length(sliding)
  const slip = corrections.unitSlipDirection
    ? speed > 0
      ? times(1 / speed, sliding)
      : zero
    : sliding
  const gravity = times(mass, g)
  const others = corrections.normalInSum ? plus(gravity, normal) : gravity
  const stays =
    corrections.staticFriction && speed === 0 && length(others) <= muStatic * Math.abs(press)
  const friction = stays ? times(-1, others) : times(-muKinetic * Math.abs(press), slip)
  const a = times(1 / mass, plus(friction, others))
  const vNew = plus(v, times(dt, a))
  return { r: plus(r, times(dt, corrections.newVelocity ? vNew : v)), v: vNew }
}
// #endregion

/** A correction of one place where the paper's text is wrong if taken literally. */
export interface Correction {
  /** The switch of `paperStep` that applies it; the last two corrections concern the paper's text about methods. */
  readonly makes?: keyof Corrections
  readonly printed: string
  readonly happens: string
  readonly corrected: string
}

/** The seven corrections, in the paper's order. */
export const corrections: readonly Correction[] = [
  {
    makes: 'normalIsVector',
    printed: 'N = −m g·n̂, a number',
    happens: 'A vector is set equal to a number. Added to both components it pushes sideways.',
    corrected: 'N = −m (g·n̂) n̂',
  },
  {
    makes: 'unitSlipDirection',
    printed: 'v̂ = v − (n̂·v) n̂, which is not of length one',
    happens: 'Friction grows with the speed: it is a drag, and never quite stops the block.',
    corrected: 'Divide by its length; where that is 0, v̂ = 0.',
  },
  {
    makes: 'normalInSum',
    printed: 'm a = F + G, without N',
    happens: 'The block sinks through the ramp.',
    corrected: 'm a = F + G + N',
  },
  {
    makes: 'staticFriction',
    printed: 'Friction at rest is not mentioned.',
    happens: 'The block never rests on a slope: put down on it, it slides off or trembles.',
    corrected: 'At rest it stays as long as the drive is no more than μs N.',
  },
  {
    makes: 'newVelocity',
    printed: 'Moving with the new velocity is called forward Euler.',
    happens:
      'It is semi-implicit Euler. Forward Euler moves with the old velocity, and errs to the other side.',
    corrected: 'Both have their names, and both are offered.',
  },
  {
    printed: 'The step does not conserve energy and momentum.',
    happens:
      'True of forward Euler’s energy, which grows; that of the paper’s own step stays within bounds.',
    corrected: 'Show the methods on one plot.',
  },
  {
    printed: 'Verlet conserves total energy, and so guarantees stability.',
    happens: 'It conserves a nearby energy, at a fixed step only, and blows up where ωΔt > 2.',
    corrected: 'Show the limit.',
  },
]
