import { handleNumbersOf } from './handleNumbers.ts'
import type { HandleNumber } from './handleNumbers.ts'
import { outline } from './ground.ts'
import { handlesOf } from './handles.ts'
import type { Layout } from './layout.ts'
import type { Handle, Picture } from './picture.ts'
import { Projection } from './projection.ts'

/** All of a picture that is the same at every time. */
export interface Setting {
  readonly picture: Picture
  readonly layout: Layout
  readonly projection: Projection
  readonly handles: readonly Handle[]
  readonly numbers: readonly HandleNumber[]
  /** Where the highest ground is: above it all is sky [px]. */
  readonly sky: number
}

export function settingOf(picture: Picture, layout: Layout): Setting {
  const projection = new Projection(picture.scene, picture.parameters, layout.camera)
  return {
    picture,
    layout,
    projection,
    handles: handlesOf(picture, layout),
    numbers: handleNumbersOf(picture, layout, projection),
    sky: Math.min(...outline(picture, layout, projection).map(({ y }) => y)),
  }
}

/** Whether two pictures differ in nothing but the time and what follows from it. */
export function isSameButTime(a: Picture, b: Picture): boolean {
  return (
    a.scene === b.scene &&
    a.parameters === b.parameters &&
    a.duration === b.duration &&
    a.runners === b.runners &&
    a.exact === b.exact &&
    a.withoutExact === b.withoutExact &&
    a.handles === b.handles &&
    !a.forces === !b.forces &&
    a.held === b.held &&
    a.lit === b.lit
  )
}
