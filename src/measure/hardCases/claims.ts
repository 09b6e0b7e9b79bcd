import type { Claims } from './claim.ts'
import { extremesClaims } from './claims/extremes.ts'
import { framesClaims } from './claims/frames.ts'
import { frictionClaims } from './claims/friction.ts'
import { jumpsClaims } from './claims/jumps.ts'
import { oscillationsClaims } from './claims/oscillations.ts'

/**
 * What holds of each hard case, by its id. Apart from the cases, so that a page which only shows them does not carry
 * it.
 */
export const hardCaseClaims: Readonly<Record<string, Claims>> = {
  ...frictionClaims,
  ...framesClaims,
  ...oscillationsClaims,
  ...extremesClaims,
  ...jumpsClaims,
}
