import { initialValues, readValues } from '../shared/control.ts'
import type { ControlValues } from '../shared/control.ts'
import type { Figure } from '../shared/figure.ts'
import { frameOf } from '../shared/still.ts'
import { face } from './face.ts'
import './figurePicture.ts'
import './framesRecorder.ts'

/** All that a figure needs from the moment it comes alive, and not before. */
export const live = {
  face,
  frameOf,
  initialValues,
  /** The element that takes the place of a figure's pictures, if one does. */
  async hostedElement({ hosted }: Figure): Promise<HTMLElement | undefined> {
    if (!hosted) return undefined
    await hosted.define()
    return Object.assign(document.createElement(hosted.tag), hosted.properties)
  },
  /** The values after a change. */
  follow(
    figure: Figure,
    given: Readonly<Record<string, unknown>>,
    before: ControlValues,
  ): ControlValues {
    const values = readValues(figure.controls, given, before)
    return figure.follow?.(values, before) ?? values
  },
}

export type Live = typeof live
