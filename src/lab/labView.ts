import { nothing } from 'lit'
import type { ReactiveControllerHost } from 'lit'
import type { ForceDrawing } from '../view/forces.ts'
import type { PictureForces } from '../view/picture.ts'
import type { Glide } from './glide.ts'
import type { LabHistory } from './labHistory.ts'
import type { Playback } from './playback/playback.ts'
import type { Lesson } from './lesson.ts'
import type { EngineChoice } from './presets/engines.ts'
import type { Preset } from './presets/preset.ts'
import type { Change } from './state/change.ts'
import type { Simulated } from './state/simulation.ts'

/** A menu's options as lit renders them, of which one may be chosen. */
export type Options = (chosen: number) => unknown

/** What the menus of presets and of engines offer; nothing until it is loaded. */
export interface Menus {
  readonly presets: readonly Preset[]
  readonly presetOptions?: Options
  readonly engines: readonly EngineChoice[]
  readonly engineOptions?: Options
}

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
  readonly history: LabHistory
  readonly menus: Menus
  /** The preset that it came from, until its note is closed. */
  readonly preset: Preset | undefined
  readonly load: (preset: Preset) => void
  readonly dismiss: () => void
  /** What readers may use and see; undefined: all. */
  readonly lesson: Lesson | undefined
}

/** What a lab sees of its panels. They are loaded when its picture is there. */
export interface Panels {
  /** What to watch in the preset that is shown. */
  note?(): unknown
  /** Why the lab does not show what was asked for. */
  readonly refusal?: (problem: string) => unknown
  /** What stands below the transport. */
  below(): unknown
  /** Lets blocks glide to their new places. Until it loads, blocks jump. */
  readonly glide: Glide
  /** The forces that the picture shows: undefined while they are switched off. */
  readonly forces?: () => PictureForces | undefined
  readonly forceDrawing?: ForceDrawing
  readonly menus?: Menus
}

export type OpenPanels = (lab: LabView & ReactiveControllerHost & HTMLElement) => Panels

/** A part of a lab, unless a lesson takes its control from readers. */
export function allowed<Part>({ lesson }: Pick<LabView, 'lesson'>, control: string, part: Part) {
  return lesson && !lesson.may(control) ? nothing : part
}
