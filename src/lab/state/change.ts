import type { ExperimentError, Scene, SceneId } from '../../physics/index.ts'
import { withParameters } from '../../measure/index.ts'
import { checked, MOST_RUNNERS } from './check.ts'
import type { DraftRunner } from './check.ts'
import { modes } from './modes.ts'
import type { ModeId } from './modes.ts'
import { openingOf } from './opening.ts'
import type { LabState, RunnerState } from './state.ts'

/** One thing that a reader can do to a lab. Values that were typed come as they are: the check judges them. */
export type Change =
  | { kind: 'scene'; scene: SceneId }
  | { kind: 'parameters'; values: Readonly<Record<string, unknown>> }
  | { kind: 'duration'; duration: unknown }
  | { kind: 'timeScale'; timeScale: unknown }
  | { kind: 'mode'; mode: ModeId }
  | { kind: 'runner'; index: number; values: Partial<DraftRunner> }
  | { kind: 'option'; index: number; of: 'frames' | 'timestep'; key: string; value: unknown }
  | { kind: 'add'; frames?: RunnerState['frames'] }
  | { kind: 'duplicate'; index: number }
  | { kind: 'remove'; index: number }
  | { kind: 'state'; state: LabState }

/**
 * The state after a change.
 *
 * @throws ExperimentError where it would be one that can't be run
 */
export function changed(state: LabState, change: Change): LabState {
  switch (change.kind) {
    case 'scene':
      return checked({ ...openingOf(change.scene), runners: state.runners })
    case 'parameters':
      return checked({ ...state, parameters: withParameters(state.parameters, change.values) })
    case 'duration':
      return checked({ ...state, duration: change.duration })
    case 'timeScale':
      return checked({ ...state, timeScale: change.timeScale })
    case 'mode': {
      const { method } = modes.find(({ id }) => id === change.mode)!
      return checked({
        ...state,
        runners: state.runners.map((each) => ({ ...each, engine: undefined, ...method })),
      })
    }
    case 'runner':
      return checked(withRunner(state, change.index, change.values))
    case 'option': {
      const chosen = { ...state.runners[change.index]![change.of], [change.key]: change.value }
      return checked(withRunner(state, change.index, { [change.of]: chosen }))
    }
    case 'add':
      return withNew(state, state.runners.length - 1, {
        frames: change.frames ?? { kind: 'steady', fps: 60 },
      })
    case 'duplicate':
      return withNew(state, change.index, {})
    case 'remove':
      return checked({ ...state, runners: state.runners.filter((_, i) => i !== change.index) })
    case 'state':
      return change.state
  }
}

/** A method that is changed is no engine's, unless the values say which. */
function withRunner(state: LabState, index: number, values: Partial<DraftRunner>) {
  const isMethod = !('frames' in values || 'hidden' in values)
  const runners = state.runners.map((each, i) =>
    i === index ? { ...each, engine: isMethod ? undefined : each.engine, ...values } : each,
  )
  return { ...state, runners }
}

/** A runner more, after the one it is modelled on, in the first look that is free. */
function withNew(state: LabState, model: number, values: Partial<RunnerState>): LabState {
  const { runners } = state
  const taken = new Set(runners.map(({ paletteIndex }) => paletteIndex))
  const paletteIndex =
    Array.from({ length: MOST_RUNNERS }, (_, i) => i).find((i) => !taken.has(i)) ?? 0
  const another = { ...runners[model]!, ...values, paletteIndex, hidden: false }
  return checked({
    ...state,
    runners: [...runners.slice(0, model + 1), another, ...runners.slice(model + 1)],
  })
}

/** Why a change can't be made, in words for the place where it was tried. */
export function refusal({ problems }: ExperimentError, change: Change, scene: Scene): string {
  return problems
    .map(({ path, message }) => {
      const option = scene.parameters[path.replace('parameters.', '')]
      const isTheirs =
        change.kind === 'parameters' && path.replace('parameters.', '') in change.values
      return option && !isTheirs ? `${option.label}: ${message}` : message
    })
    .join(' ')
}
