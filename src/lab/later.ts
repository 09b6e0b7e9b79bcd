import type { ReactiveControllerHost } from 'lit'
import type { PictureForces } from '../view/picture.ts'
import type { Glide } from './glide.ts'
import type { LabView } from './labView.ts'
import type { Preset } from './presets/preset.ts'

/** What a lab has besides its picture and what moves that: it is loaded when these are there. */
export interface Later {
  /** What stands below the transport. */
  below(): unknown
  /** Lets blocks glide to their new places: before it is there, they are there at once. */
  readonly glide: Glide
  /** What the picture shows of forces: nothing while they are switched off. */
  readonly forces?: () => PictureForces | undefined
  readonly presets?: readonly Preset[]
}

export type MakeLater = (lab: LabView & ReactiveControllerHost & HTMLElement) => Later
