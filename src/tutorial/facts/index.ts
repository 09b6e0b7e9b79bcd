import { damping } from './damping.ts'
import { energy } from './energy.ts'
import type { Fact } from './fact.ts'
import { forcesOnASlope } from './forcesOnASlope.ts'
import { fromForces } from './fromForces.ts'
import { paper } from './paper.ts'
import { realFrames } from './realFrames.ts'
import { stopping } from './stopping.ts'
import { tolerance } from './tolerance.ts'
import { toPosition } from './toPosition.ts'
import { whatMoves } from './whatMoves.ts'
import { whatToUse } from './whatToUse.ts'

const all = {
  ...whatMoves,
  ...forcesOnASlope,
  ...fromForces,
  ...toPosition,
  ...stopping,
  ...realFrames,
  ...damping,
  ...energy,
  ...tolerance,
  ...whatToUse,
  ...paper,
}

/** The numbers of the prose by name, written as people read them; a number and its unit stay on one line. */
export const facts: Readonly<Record<string, () => string>> = Object.fromEntries(
  Object.entries<Fact>(all).map(([name, { value, show }]) => [name, () => show(value())]),
)

/** The same as numbers, in SI units. */
export const values = Object.fromEntries(
  Object.entries<Fact>(all).map(([name, { value }]) => [name, value]),
) as Readonly<Record<keyof typeof all, () => number>>
