import { extremesClaims } from './extremes.ts'
import { framesClaims } from './frames.ts'
import { frictionClaims } from './friction.ts'
import { jumpsClaims } from './jumps.ts'
import { oscillationsClaims } from './oscillations.ts'
import type { Claims } from './hardCase.ts'

/**
 * What holds of each hard case, by its id. Apart from the list of cases, so that a bundle which only shows them does not
 * carry it: bundlers keep a spread whether it is used or not.
 */
export const hardCaseClaims: Readonly<Record<string, Claims>> = {
  ...frictionClaims,
  ...framesClaims,
  ...oscillationsClaims,
  ...extremesClaims,
  ...jumpsClaims,
}
