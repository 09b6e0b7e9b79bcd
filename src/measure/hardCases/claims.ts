import { crestAndBeltClaims } from './crestAndBelt.ts'
import { edgesClaims } from './edges.ts'
import { extremesClaims } from './extremes.ts'
import { framesClaims } from './frames.ts'
import { frictionClaims } from './friction.ts'
import { jumpsClaims } from './jumps.ts'
import { limitsClaims } from './limits.ts'
import { oscillationsClaims } from './oscillations.ts'
import { tolerancesClaims } from './tolerances.ts'
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
  ...edgesClaims,
  ...limitsClaims,
  ...crestAndBeltClaims,
  ...tolerancesClaims,
}
