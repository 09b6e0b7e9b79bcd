import { clamp, overlap } from '../chart/geometry.ts'
import type { Box, Point } from '../chart/geometry.ts'

/** A label that wants to stand above a point, like a flag at its pole. */
export interface Pole {
  /** The foot of the pole: the top of a block. */
  readonly foot: Point
  readonly width: number
  readonly height: number
  /** The side of the pole on which the label hangs: 1 to the left, 0 to the right, between them between. */
  readonly lean: number
  /** Others give way to it where there isn't room for all. */
  readonly sure: boolean
}

/** Where a label stands. `aside`: in a table, not at its pole. */
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

/**
 * Places labels one after the other, each above its pole's foot and above everything that is in its way: the
 * `obstacles` and the labels before it. In a fixed order labels move as continuously as their poles: none flickers
 * while blocks overtake each other. Those for which a stack has no room stand aside, in a table at the canvas's top,
 * in the `sky` above all ground [px]; one for which that has none either is undefined.
 */
export function placeLabels(
  poles: readonly Pole[],
  obstacles: readonly Box[],
  sky: number,
  width: number,
  aside = new Set<Pole>(),
): (Placed | undefined)[] {
  const placed = new Map<Pole, Placed>()
  const taken = [...obstacles]
  let last: Pole | undefined
  for (const pole of poles) {
    if (aside.has(pole)) continue
    if (!pole.sure) last = pole
    const box = raised(pole, taken, width)
    // One that is sure of its place takes that of the nearest below it.
    if (box.top < MARGIN) return placeLabels(poles, obstacles, sky, width, aside.add(last ?? pole))
    placed.set(pole, box)
    taken.push(box)
  }
  for (const [{ foot }, { top }] of placed)
    taken.push({ left: foot.x, right: foot.x, top, bottom: foot.y })
  const widest = Math.max(...poles.map((pole) => pole.width))
  // In the order in which a stack that has less and less room gives them up: those that are there keep their places.
  const rest = poles.filter((pole) => aside.has(pole)).reverse()
  for (const pole of rest.sort((a, b) => +b.sure - +a.sure)) {
    const box = tabled(pole, widest, taken, sky, width)
    if (!box) continue
    placed.set(pole, box)
    taken.push(box)
  }
  return poles.map((pole) => placed.get(pole))
}

function raised(
  { foot, width, height, lean }: Pole,
  taken: readonly Box[],
  canvas: number,
): Placed {
  const beside = foot.x - lean * (width + BESIDE) + (1 - lean) * BESIDE
  const left = clamp(beside, Math.min(MARGIN, canvas - MARGIN - width), canvas - MARGIN - width)
  const right = left + width
  let bottom = foot.y - 12
  for (let changed = true; changed;) {
    changed = false
    for (const other of taken) {
      const apart = Math.max(other.left - right, left - other.right, 0)
      const limit = other.top - GAP + STEEP * apart
      // What is wholly above is not in the way.
      if (bottom > limit && bottom - height < other.bottom + GAP) {
        bottom = limit
        changed = true
      }
    }
  }
  return { left, top: bottom - height, right, bottom, aside: false }
}

/** The first free place of a table that keeps still, in columns from the canvas's upper corners inwards. */
function tabled(
  { width, height }: Pole,
  widest: number,
  taken: readonly Box[],
  sky: number,
  canvas: number,
): Placed | undefined {
  const last = canvas - MARGIN - widest
  for (let inwards = 0; inwards <= last - MARGIN; inwards += widest + BESIDE) {
    for (const left of [MARGIN + inwards, last - inwards]) {
      const right = left + width
      for (let bottom = MARGIN + height; bottom < sky - GAP; bottom += height + GAP) {
        const box = { left, top: bottom - height, right, bottom, aside: true }
        if (!taken.some((other) => overlap(box, other, GAP))) return box
      }
    }
  }
  return undefined
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
