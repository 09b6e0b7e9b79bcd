import { explicitEuler } from './explicitEuler.ts'
import { semiImplicitEuler } from './semiImplicitEuler.ts'
import { velocityVerlet } from './velocityVerlet.ts'
import { midpoint } from './midpoint.ts'
import { rk4 } from './rk4.ts'
import { rk8 } from './rk8.ts'
import { yoshida4 } from './yoshida4.ts'
import { implicitMidpoint } from './implicitMidpoint.ts'

/** Every integrator, the simplest first. */
export const integrators = [
  explicitEuler,
  semiImplicitEuler,
  velocityVerlet,
  midpoint,
  rk4,
  rk8,
  yoshida4,
  implicitMidpoint,
] as const

export type IntegratorId = (typeof integrators)[number]['id']
