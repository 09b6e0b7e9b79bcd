import { perFrame } from './perFrame.ts'
import { variable } from './variable.ts'
import { capped } from './capped.ts'
import { substeps } from './substeps.ts'
import { fixed } from './fixed.ts'
import { toTolerance } from './tolerance.ts'

/** Every timestep policy, from the classic bug to the classic cure. */
export const timesteps = [perFrame, variable, capped, substeps, fixed, toTolerance] as const

export type TimestepId = (typeof timesteps)[number]['id']
