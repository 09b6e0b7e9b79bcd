import { ExperimentError, parseExperiment, scenes, timesteps } from '../physics/index.ts'
import type { Problem, ResolvedExperiment, SceneId } from '../physics/index.ts'
import { readNumber } from '../chart/typedNumber.ts'
import { choose } from '../lab/state/choose.ts'
import { experimentOf, MOST_RUNNERS } from '../lab/state/check.ts'
import { opening, openingOf } from '../lab/state/opening.ts'
import type { LabState } from '../lab/state/state.ts'
import { together } from '../lab/state/together.ts'

/**
 * What a page asks of a lab by attributes, as text, or by properties, as values:
 *
 * - `experiment`: an experiment, or a list of some that share scene, parameters and duration; as JSON in an attribute
 * - `scene`, `integrator`, `stopping`: an id; `duration` [s]: in the place of what `experiment` says
 * - `fps`: a frame rate for each block, as `10 30 120`
 * - `timestep`: the id of a policy, which is then at its initial options; or as in an experiment
 */
export type Asked = {
  readonly [
    name in 'experiment' | 'scene' | 'fps' | 'integrator' | 'stopping' | 'timestep' | 'duration'
  ]?: unknown
}

type Loose = Readonly<Record<string, unknown>>

/**
 * The state that a page asks for; what it does not say is as in the opening of the scene.
 *
 * @throws ExperimentError that lists every problem, by the attribute that it is in
 */
export function stateAsked(asked: Asked): LabState {
  const problems: Problem[] = []
  const given = json(asked.experiment, 'experiment', problems)
  const told = new Set<string>()
  const runs: ResolvedExperiment[] = []
  if (problems.length > 0) throw new ExperimentError(problems)
  const wanted = withRates(given === undefined ? start(asked.scene) : [given].flat(), asked.fps)
  if (wanted.length < 1 || wanted.length > MOST_RUNNERS) {
    const path = isGiven(asked.fps) ? 'fps' : 'experiment'
    const message = `asks for ${wanted.length} blocks, which are not in 1…${MOST_RUNNERS}`
    throw new ExperimentError([{ path, message }])
  }
  const timestep = json(asked.timestep, 'timestep', problems)
  wanted.forEach((each, i) => {
    try {
      runs.push(parseExperiment(isObject(each) ? changed(each, asked, timestep) : each))
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      for (const { path, message } of error.problems) {
        const place = placeOf(path, asked, wanted.length > 1 ? `experiment[${i}]` : 'experiment')
        if (!told.has(place + message)) problems.push({ path: place, message })
        told.add(place + message)
      }
    }
  })
  if (problems.length > 0) throw new ExperimentError(problems)
  return together(runs, 'experiment')
}

function start(scene: unknown): unknown[] {
  const isKnown = scenes.some(({ id }) => id === scene)
  const state = isKnown ? openingOf(scene as SceneId) : opening
  return state.runners.map((runner) => experimentOf(state, runner))
}

/** One for each frame rate asked for, where any is. */
function withRates(list: readonly unknown[], fps: unknown): readonly unknown[] {
  if (!isGiven(fps)) return list
  const rates = typeof fps === 'string' ? fps.split(/[\s,;]+/).filter(Boolean) : [fps].flat()
  return rates.map((rate, i) => {
    const model = list[i] ?? list.at(-1)
    return isObject(model) ? { ...model, frames: { kind: 'steady', fps: number(rate) } } : model
  })
}

function changed(experiment: Loose, asked: Asked, timestep: unknown): Loose {
  const result: Record<string, unknown> = { ...experiment }
  for (const name of ['scene', 'integrator', 'stopping'] as const)
    if (isGiven(asked[name])) result[name] = asked[name]
  if (isGiven(asked.duration)) result.duration = number(asked.duration)
  if (isGiven(timestep)) result.timestep = isObject(timestep) ? timestep : named(timestep)
  return result
}

/** A policy by its name. One that there is not is left for the check to tell of. */
function named(kind: unknown): unknown {
  const policy = timesteps.find(({ id }) => id === kind)
  return policy ? choose('timestep', policy.id, { kind: 'variable' }) : { kind }
}

/** The attribute that a problem is in, or its place in the experiment that was given. */
function placeOf(path: string, asked: Asked, experiment: string): string {
  if (path === 'frames.fps' && isGiven(asked.fps)) return 'fps'
  const [name] = path.split('.')
  if (isGiven(asked[name as keyof Asked])) return path.replace(/\.kind$/, '')
  if (!isGiven(asked.experiment)) return path
  return path ? `${experiment}.${path}` : experiment
}

function json(value: unknown, path: string, problems: Problem[]): unknown {
  if (!isGiven(value)) return undefined
  if (typeof value !== 'string' || (path === 'timestep' && !value.trim().startsWith('{')))
    return value
  try {
    return JSON.parse(value)
  } catch (error) {
    problems.push({ path, message: `is not JSON: ${(error as Error).message}` })
    return undefined
  }
}

function number(value: unknown): unknown {
  return typeof value === 'string' ? (readNumber(value) ?? value) : value
}

/** An attribute that is not there is null. */
function isGiven(value: unknown): boolean {
  return value !== undefined && value !== null && value !== ''
}

function isObject(value: unknown): value is Loose {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}
