import { crestAndBelt } from './crestAndBelt.ts'
import { edges } from './edges.ts'
import { extremes } from './extremes.ts'
import { frames } from './frames.ts'
import { friction } from './friction.ts'
import type { HardCase } from './hardCase.ts'
import { jumps } from './jumps.ts'
import { limits } from './limits.ts'
import { oscillations } from './oscillations.ts'
import { tolerances } from './tolerances.ts'

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
