import type { Past } from './past.ts'
import type { Playback } from './playback/playback.ts'
import type { Preset } from './presets/preset.ts'
import type { Simulated } from './state/simulation.ts'
import type { Change } from './state/state.ts'

/** What the parts of a lab see of it. */
export interface LabView {
  readonly simulated: Simulated
  readonly playback: Playback
  /** The runner that is looked at closely. */
  readonly selected: number
  readonly select: (index: number) => void
  /** Makes a change; answers with what is wrong with it, or with nothing. */
  readonly change: (change: Change) => string
  /** Undo and redo. */
  readonly past: Past
  /** All that there are; none until they are loaded. */
  readonly presets: readonly Preset[]
  /** The preset that it came from, until its note is closed. */
  readonly preset: Preset | undefined
  readonly load: (preset: Preset) => void
  readonly dismiss: () => void
}
