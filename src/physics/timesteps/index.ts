import { entry } from '../lists.ts'
import type { ChosenWhole } from '../options.ts'
import type { TimestepPolicy } from '../timestepPolicy.ts'
import { perFrame } from './perFrame.ts'
import { variable } from './variable.ts'
import { capped } from './capped.ts'
import { substeps } from './substeps.ts'
import { fixed } from './fixed.ts'
import { toTolerance } from './tolerance.ts'

/** Every timestep policy, from the classic bug to the classic cure. */
export const timesteps = [perFrame, variable, capped, substeps, fixed, toTolerance] as const

export type TimestepId = (typeof timesteps)[number]['id']

type Choices = {
  [Id in TimestepId]: Extract<ChosenWhole<(typeof timesteps)[number]>, { kind: Id }>
}
type Policies = { [Id in TimestepId]: TimestepPolicy<Choices[Id]> }

/** The policy that an experiment names, with the options that it has there. */
export function policyOf<Id extends TimestepId>(choice: Choices[Id]) {
  const policy = entry<Policies[TimestepId], Policies[Id]>(timesteps, choice.kind)
  return {
    start: () => policy.start(choice),
    steps: (duration: number, frames: number) => policy.steps(choice, duration, frames),
  }
}
