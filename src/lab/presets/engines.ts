import { preset } from './preset.ts'
import type { Preset } from './preset.ts'
import { checked } from '../state/check.ts'
import type { LabState } from '../state/state.ts'
import { bevy } from '../../engines/bevy.ts'
import { gameMaker } from '../../engines/gameMaker.ts'
import { godot } from '../../engines/godot.ts'
import { engines } from '../../engines/index.ts'
import { phaser } from '../../engines/phaser.ts'
import { unityFixedUpdate } from '../../engines/unityFixedUpdate.ts'
import { unreal } from '../../engines/unreal.ts'

/** What the menu of engines offers. */
export interface EngineChoice {
  readonly label: string
  /** The lab as it is, with the choice made of its runners; `selected` is the one that is looked at. */
  readonly presetOf: (state: LabState, selected: number) => Preset
}

const GROUP = 'Your engine'

/** Six engines, as different as they come. */
const compared = [unityFixedUpdate, godot, unreal, bevy, phaser, gameMaker]

const comparison: EngineChoice = {
  label: 'Compare engines',
  presetOf: (state, selected) =>
    preset(
      GROUP,
      comparison.label,
      'Six engines at their defaults, all on the same frames. Choose one of them in the menu to read what it does, and what is left out here.',
      () =>
        checked({
          ...state,
          runners: compared.map(({ method, label: engine }, paletteIndex) => ({
            ...{ ...method, engine },
            ...{ frames: state.runners[selected]!.frames, paletteIndex, hidden: false },
          })),
        }),
      state,
    ),
}

/** The comparison, and each engine: it moves all runners, which keep their frames. */
export const engineChoices: readonly EngineChoice[] = [
  comparison,
  ...engines.map(({ label, method, does, leavesOut, source }) => ({
    label,
    presetOf: (state: LabState) =>
      preset(
        GROUP,
        label,
        `${does} ${leavesOut} Source: ${source}.`,
        () =>
          checked({
            ...state,
            runners: state.runners.map((each) => ({ ...each, ...method, engine: label })),
          }),
        state,
      ),
  })),
]
