import { crestAndBelt, crestAndBeltClaims } from './crestAndBelt.ts'
import { edges, edgesClaims } from './edges.ts'
import { extremes, extremesClaims } from './extremes.ts'
import { frames, framesClaims } from './frames.ts'
import { friction, frictionClaims } from './friction.ts'
import type { HardCase, Claims } from './hardCase.ts'
import { jumps, jumpsClaims } from './jumps.ts'
import { limits, limitsClaims } from './limits.ts'
import { oscillations, oscillationsClaims } from './oscillations.ts'
import { tolerances, tolerancesClaims } from './tolerances.ts'

/** Every hard case, in the order of their groups. */
export const hardCases: readonly HardCase[] = [
  ...friction,
  ...frames,
  ...oscillations,
  ...extremes,
  ...jumps,
  ...edges,
  ...limits,
  ...crestAndBelt,
  ...tolerances,
].sort((one, other) => one.group - other.group)

export type { HardCase } from './hardCase.ts'

/**
 * What holds of each hard case, by its id. Apart from the list of cases, so that a bundle which only shows them does not
 * carry it.
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
