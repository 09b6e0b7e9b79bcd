import { figurePresets } from './figures.ts'
import { hardPresets } from './hardCases.ts'
import { kicks } from './kicks.ts'
import type { Preset } from './preset.ts'

/** Every preset, in the order of the menu. */
export const presets: readonly Preset[] = [...kicks, ...figurePresets, ...hardPresets]
