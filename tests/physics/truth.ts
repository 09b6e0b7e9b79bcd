import { scenes } from '../../src/physics/index.ts'
import type { Experiment, Outcome, SceneId } from '../../src/physics/index.ts'
import bendCases from './truth-bends.json'
import newCases from './truth-new-scenes.json'
import cases from './truth.json'

/** A motion that was computed to 20 digits by independent means: see README.md beside this file. */
interface Truth {
  name: string
  /** Scene, parameters and duration; the rest is for a test to add. */
  experiment: Experiment
  duration: number
  s: number
  v: number
  outcome: Outcome['kind']
}

export interface TruthCase extends Truth {
  stops: readonly number[]
}

export interface BendCase extends Truth {
  /** How far s moves when each input moves by 2⁻⁵³ of itself [m]. */
  condition: number
  /** When the block comes to rest or leaves the track [s]; undefined where it does neither. */
  time: number | undefined
}

/** What a case does not name is 0 there, but gravity and mass. */
const unnamed: Record<string, number> = { gravity: 9.81, mass: 1 }

export const truth: readonly TruthCase[] = cases.map((each, i) => ({
  ...read(each, i),
  stops: each.stops.map(Number),
}))

/** Motions through bends, many of them from rest. */
export const bends: readonly BendCase[] = bendCases.map((each, i) => ({
  ...read(each, i),
  condition: each.condition,
  time: each.time === null ? undefined : Number(each.time),
}))

export interface NewCase extends Truth {
  /** When the block takes off from a crest [s]; undefined where it does not, and on a belt. */
  time: number | undefined
  /** When a spring tears the block off the belt [s]; empty where it never sticks, and on a crest. */
  releases: readonly number[]
}

/** Motions over a crest and on a belt. */
export const newScenes: readonly NewCase[] = newCases.map((each, i) => ({
  ...read(each, i),
  time: each.time ? Number(each.time) : undefined,
  releases: (each.releases ?? []).map(Number),
}))

function read(
  each: {
    scene: string
    parameters: object
    duration: number
    s: string
    v: string
    outcome: string
  },
  i: number,
): Truth {
  const { parameters } = scenes.find(({ id }) => id === each.scene)!
  const given = { ...each.parameters } as Record<string, number | undefined>
  // A case that names kinetic friction alone has static friction of the same size: less would be refused.
  given.muStatic ??= given.muKinetic
  return {
    name: `${i}: ${each.scene} ${JSON.stringify(each.parameters)}`,
    experiment: {
      scene: each.scene as SceneId,
      parameters: Object.fromEntries(
        Object.keys(parameters).map((name) => [name, given[name] ?? unnamed[name] ?? 0]),
      ),
      duration: each.duration,
    },
    duration: each.duration,
    s: Number(each.s),
    v: Number(each.v),
    outcome: each.outcome as Outcome['kind'],
  }
}

/** An error as the promises are made: relative to the distance, or absolute below a metre. */
export function relative(error: number, s: number): number {
  return Math.abs(error) / Math.max(1, Math.abs(s))
}

/** The last element. */
export function last(values: Float64Array): number {
  return values[values.length - 1]!
}
