import { ExperimentError, parseExperiment } from '../../physics/index.ts'
import type { Experiment, Problem } from '../../physics/index.ts'
import type { LabState, RunnerState } from './state.ts'

/** As many as there are colours that can be told apart. */
export const MOST_RUNNERS = 8

/** A lab state of which nothing is known yet: from an address, a field, a message. */
export interface Draft {
  readonly scene: unknown
  readonly parameters: unknown
  readonly duration: unknown
  readonly timeScale: unknown
  readonly runners: readonly DraftRunner[]
}

/** A runner of which nothing is known yet. */
export type DraftRunner = { readonly [K in keyof RunnerState]: unknown }

/** The experiment that a runner of a lab runs. */
export function experimentOf(state: LabState, runner: RunnerState): Experiment {
  const { scene, parameters, duration, timeScale } = state
  const { frames, timestep, integrator, stopping } = runner
  const own = { frames, timestep, integrator, stopping }
  return { scene, parameters, duration, timeScale, ...own } as Experiment
}

/**
 * The draft as a lab state with nothing left out.
 *
 * @throws ExperimentError that lists every problem, those of a runner under `runners[i]`
 */
export function checked(draft: Draft): LabState {
  const problems: Problem[] = []
  const told = new Set<string>()
  const report = (path: string, message: string) => {
    // What the runners share is wrong for each of them, and told once.
    const whole = `${path}: ${message}`
    if (!told.has(whole)) problems.push({ path, message })
    told.add(whole)
  }
  const { length } = draft.runners
  if (length < 1 || length > MOST_RUNNERS)
    report('runners', `${length} are not in 1…${MOST_RUNNERS}`)
  let shared: Omit<LabState, 'runners'> | undefined
  const runners: RunnerState[] = []
  draft.runners.slice(0, MOST_RUNNERS).forEach((runner, i) => {
    const paletteIndex = checkedPaletteIndex(runner.paletteIndex, `runners[${i}].look`, report)
    try {
      const { scene, parameters, duration, timeScale, ...own } = parseExperiment(
        experimentOf(draft as LabState, runner as RunnerState),
      )
      shared = { scene, parameters, duration, timeScale }
      const engine = runner.engine as RunnerState['engine']
      runners.push({ ...own, paletteIndex, hidden: runner.hidden === true, engine })
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      for (const { path, message } of error.problems)
        report(isShared(path) ? path : `runners[${i}].${path}`, message)
    }
  })
  if (problems.length > 0 || !shared) throw new ExperimentError(problems)
  return { ...shared, runners }
}

function isShared(path: string): boolean {
  return /^(scene|parameters|duration|timeScale)\b/.test(path)
}

function checkedPaletteIndex(
  value: unknown,
  path: string,
  report: (path: string, message: string) => void,
): number {
  if (typeof value === 'number' && Number.isInteger(value) && value >= 0 && value < MOST_RUNNERS)
    return value
  report(path, `${String(value)} is not a whole number in 0…${MOST_RUNNERS - 1}`)
  return 0
}
