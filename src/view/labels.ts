import { clamp } from './geometry.ts'
import type { Box, Point } from './geometry.ts'

/** A label that wants to stand above a point, like a flag at its pole. */
export interface Pole {
  /** The foot of the pole: the top of a block. */
  readonly foot: Point
  readonly width: number
  readonly height: number
  /** The side of the pole on which the label hangs: 1 to the left, 0 to the right, between them between. */
  readonly lean: number
}

/** Where a label stands. `aside`: in a further column, not at its pole. */
export interface Placed extends Box {
  readonly aside: boolean
}

/** The gap between a label and what is next to it [px]. */
const GAP = 3
/** Between a pole and its label. */
const BESIDE = 6
/** How fast a label gives way to something it comes near: less than infinitely, so that it never jumps. */
const STEEP = 1.2
/** Of the canvas's edge. */
const MARGIN = 6

/** How many columns of labels there are at most: a stack too high for the canvas goes on beside itself. */
const COLUMNS = 4

/**
 * Places labels one after the other, each above its pole's foot and above everything that is in its way: the
 * `obstacles` and the labels before it. In a fixed order labels move as continuously as their poles: none flickers
 * while blocks overtake each other. One for which the canvas has no room is undefined.
 */
export function placeLabels(
  poles: readonly Pole[],
  obstacles: readonly Box[],
  width: number,
): (Placed | undefined)[] {
  const taken = [...obstacles]
  const step = Math.max(...poles.map((pole) => pole.width)) + 2 * BESIDE
  return poles.map((pole) => {
    const side = pole.lean > 0.5 ? -1 : 1
    for (let column = 0; column < COLUMNS; column++) {
      const box = raised(pole, side * column * step, taken, width)
      if (box.top < MARGIN || box.left < 0) continue
      taken.push(box)
      return { ...box, aside: column > 0 }
    }
    return undefined
  })
}

function raised(
  { foot, width, height, lean }: Pole,
  aside: number,
  taken: readonly Box[],
  canvas: number,
): Box {
  const beside = foot.x + aside - lean * (width + BESIDE) + (1 - lean) * BESIDE
  const left = clamp(beside, Math.min(MARGIN, canvas - MARGIN - width), canvas - MARGIN - width)
  const right = left + width
  let bottom = foot.y - 12
  for (let changed = true; changed;) {
    changed = false
    for (const other of taken) {
      const apart = Math.max(other.left - right, left - other.right, 0)
      // Those that had to go aside stand close together.
      const limit = other.top - GAP + (aside === 0 ? STEEP * apart : apart > 0 ? Infinity : 0)
      // What is wholly above is not in the way.
      if (bottom > limit && bottom - height < other.bottom + GAP) {
        bottom = limit
        changed = true
      }
    }
  }
  return { left, top: bottom - height, right, bottom }
}

/**
 * Sets labels in a column, in their order from top to bottom, each as near as can be to the height it wants: those
 * that would overlap share the difference. Heights are of their middles.
 */
export function placeColumn(
  wanted: readonly number[],
  height: number,
  low: number,
  high: number,
): number[] {
  // Without their own heights they only need to be in order: neighbours in disorder settle on their mean.
  const groups: { sum: number; count: number }[] = []
  wanted.forEach((y, i) => {
    groups.push({ sum: y - i * height, count: 1 })
    for (let n = groups.length; n > 1 && mean(groups[n - 2]!) >= mean(groups[n - 1]!); n--) {
      const last = groups.pop()!
      groups[n - 2]!.sum += last.sum
      groups[n - 2]!.count += last.count
    }
  })
  const from = low + height / 2
  const to = Math.max(from, high - height / 2 - (wanted.length - 1) * height)
  return groups
    .flatMap((group) => Array.from({ length: group.count }, () => clamp(mean(group), from, to)))
    .map((y, i) => y + i * height)
}

function mean({ sum, count }: { sum: number; count: number }): number {
  return sum / count
}
