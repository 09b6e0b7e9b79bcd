import type { Experiment, Outcome, SceneId } from '../../src/physics/index.ts'
import cases from './truth-bends.json'

/** A motion round a bend or in a pipe, computed to 20 digits by independent means: shared/truth-bends.json of the brief. */
export interface BendCase {
  name: string
  /** Scene, every parameter, and duration. */
  experiment: Experiment
  s: number
  v: number
  /** How far s at the end moves when each input moves by 2⁻⁵³ [m]. */
  condition: number
  outcome: Outcome['kind']
  /** When it stopped or left the track [s]; undefined while it moves. */
  time: number | undefined
}

export const bends: readonly BendCase[] = cases.map((each, i) => ({
  name: `${i}: ${each.scene} ${JSON.stringify(each.parameters)}`,
  experiment: {
    scene: each.scene as SceneId,
    parameters: each.parameters,
    duration: each.duration,
  },
  s: Number(each.s),
  v: Number(each.v),
  condition: each.condition,
  outcome: each.outcome as Outcome['kind'],
  time: each.time === null ? undefined : Number(each.time),
}))
