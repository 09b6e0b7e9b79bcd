import { clamp } from '../chart/geometry.ts'
import type { Picture } from './picture.ts'
import { viewOf } from './scenes.ts'

/** Sizes in pixels that do not depend on the scale. */
export interface Sizes {
  /** The side of a block. */
  readonly block: number
  /**
   * Below the track, one lane of dots a runner: how deep the first lies, how far each further one is, and where they
   * end.
   */
  readonly lanes: { readonly first: number; readonly gap: number; readonly depth: number }
  /** The height of a label. */
  readonly row: number
  /** The length of the arrow of 1 m/s. */
  readonly arrow: number
  /** The length of the longest force's arrow. */
  readonly force: number
}

/** How thick a belt is around its rollers: the dots of all lanes lie inside it [px]. */
export function beltDepth({ depth }: Sizes['lanes']): number {
  return depth + 24
}

/** How far the arrow's tip is from the block's middle at no speed, so that it can be pulled out. */
export const ARROW_START = 42

/** From the block's middle to the tip of its arrow, along the track: negative against growing s. */
export function arrowReach({ scene, parameters }: Picture, arrow: number): number {
  const v = parameters.speed!
  // No speed has no direction: then to the right, or down.
  const sign = v < 0 ? -1 : v > 0 ? 1 : scene.facing
  return sign * (ARROW_START + arrow * Math.abs(v))
}

export function sizesOf(
  { scene, parameters, runners }: Picture,
  width: number,
  height: number,
): Sizes {
  const count = runners.length
  const first = 11
  const gap = count <= 3 ? 9 : count <= 5 ? 7 : 5
  const longest = 0.28 * (viewOf(scene).falls ? height : width) - 10
  return {
    block: clamp(28 + 0.016 * width, 34, 46),
    lanes: { first, gap, depth: first + gap * Math.max(0, count - 1) + 4 },
    row: width < 480 || count > 4 ? 16 : 18,
    arrow: Math.min(
      clamp(width / 40, 10, 26),
      longest / Math.max(1e-9, Math.abs(parameters.speed!)),
    ),
    force: clamp(Math.min(0.26 * height, 0.2 * width), 48, 104),
  }
}
