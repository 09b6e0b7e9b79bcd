import { html } from 'lit'
import type { LabView } from '../../lab/labView.ts'
import { MOST_RUNNERS } from '../../lab/state/check.ts'

interface Use {
  readonly lab: LabView
  /** The name of the selected runner. */
  readonly selected: string
  /** What to use, once that is asked for [s]. */
  readonly durations: () => readonly number[]
  /** Told what has been done, or why it can't be. */
  readonly tell: (message: string) => void
  /** What the frames are called. */
  readonly whose: string
}

/** Buttons that make frame times the clock of a runner. */
export function useFrames({ lab, selected, durations, tell, whose }: Use) {
  const frames = () => ({ kind: 'recorded', durations: durations() }) as const
  const use = () => {
    const values = { frames: frames() }
    tell(
      lab.change({ kind: 'runner', index: lab.selected, values }) ||
        `${selected} now has ${whose}.`,
    )
  }
  const add = () => {
    const problem = lab.change({ kind: 'add', frames: frames() })
    tell(problem || `A new runner has ${whose}.`)
    if (!problem) lab.select(lab.simulated.runners.length - 1)
  }
  return html`<button type="button" class="add" @click=${use}>Use for ${selected}</button>
    <button
      type="button"
      class="add"
      ?disabled=${lab.simulated.runners.length >= MOST_RUNNERS}
      @click=${add}
    >
      Use for a new runner
    </button>`
}
