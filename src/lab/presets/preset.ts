import { ExperimentError } from '../../physics/index.ts'
import { opening } from '../state/opening.ts'
import type { LabState } from '../state/state.ts'

/** An experiment with a name that a lab can be set to. */
export interface Preset {
  /** What kind of experiment it is; those of one kind stand together in the menu. */
  readonly group: string
  readonly label: string
  /** What to look at when it is shown, in a sentence or two. */
  readonly watch: string
  /** What a lab shows then: the same value every time. */
  readonly shown: Shown
}

/** A lab, and why it is not the one that was asked for, if that can't be run: a sentence, then a line for each problem. */
interface Shown {
  readonly state: LabState
  readonly problem: string
}

/**
 * A preset that is put together when it is first asked for.
 *
 * @param otherwise what a lab shows if that can't be run: the lab as it is, if it is asked for there
 */
export function preset(
  group: string,
  label: string,
  watch: string,
  make: () => LabState,
  otherwise = opening,
): Preset {
  let shown: Shown | undefined
  return {
    group,
    label,
    watch,
    get shown() {
      return (shown ??= attempt(label, make, otherwise))
    },
  }
}

function attempt(label: string, make: () => LabState, otherwise: LabState): Shown {
  try {
    return { state: make(), problem: '' }
  } catch (error) {
    if (!(error instanceof ExperimentError)) throw error
    const instead = otherwise === opening ? 'shows its opening instead' : 'stays as it is'
    const problem = `“${label}” can’t be run here. The lab ${instead}.\n${error.message}`
    return { state: otherwise, problem }
  }
}
