import { ExperimentError, parseExperiment } from '../../physics/index.ts'
import type { ResolvedExperiment } from '../../physics/index.ts'
import { MOST_RUNNERS } from './check.ts'
import type { LabState } from './state.ts'

/**
 * Runs as one lab.
 *
 * @param path where the list of them stands
 * @throws ExperimentError where they differ in what a lab's runners share
 */
export function together(runs: readonly ResolvedExperiment[], path: string): LabState {
  const sharedBy = ({ scene, parameters, duration, timeScale }: ResolvedExperiment) => {
    return { scene, parameters, duration, timeScale }
  }
  const shared = sharedBy(runs[0]!)
  const problems = runs.flatMap((run, i) =>
    JSON.stringify(sharedBy(run)) === JSON.stringify(shared)
      ? []
      : [
          {
            path: `${path}[${i}]`,
            message:
              'is not like the first in scene, parameters, duration and time scale, which a lab shares',
          },
        ],
  )
  if (problems.length > 0) throw new ExperimentError(problems)
  const runners = runs.map(({ frames, timestep, integrator, stopping }, paletteIndex) => {
    return { frames, timestep, integrator, stopping, paletteIndex, hidden: false }
  })
  return { ...shared, runners }
}

/** The experiments in a text that *Copy as JSON* has written; undefined where it is something else. */
export function experimentsIn(text: string): unknown[] | undefined {
  if (!/^\s*[[{]/.test(text)) return undefined
  let value: unknown
  try {
    value = JSON.parse(text)
  } catch {
    return undefined
  }
  const list = [value].flat()
  const isExperiment = (each: unknown) =>
    typeof each === 'object' && each !== null && 'scene' in each
  return list.length > 0 && list.every(isExperiment) ? list : undefined
}

/**
 * A lab that shows experiments.
 *
 * @throws ExperimentError that lists every problem
 */
export function labOf(experiments: readonly unknown[]): LabState {
  const { length } = experiments
  if (length < 1 || length > MOST_RUNNERS)
    throw new ExperimentError([
      { path: 'runners', message: `${length} are not in 1…${MOST_RUNNERS}` },
    ])
  return together(experiments.map(parseExperiment), 'runners')
}
