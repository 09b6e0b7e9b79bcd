import { frontier, leastDifference } from '../../measure/index.ts'
import { logScale } from '../../chart/axis.ts'
import type { LogScale } from '../../chart/axis.ts'
import { decadeAbove, decadeBelow } from '../../chart/magnitudes.ts'
import type { DiagramCurve, DiagramPoint } from './points.ts'

/** A point of the diagram and where it is drawn [px]. */
export interface DiagramSpot {
  readonly point: DiagramPoint
  readonly x: number
  readonly y: number
}

/** A curve and where it is drawn. */
export interface Drawn {
  readonly curve: DiagramCurve
  readonly spots: readonly DiagramSpot[]
  /** Of its label, if it has one [px]. */
  readonly labelY: number | undefined
}

/** Where everything in the diagram is [px]. */
export interface DiagramLayout {
  readonly width: number
  readonly height: number
  /** Of the field that is drawn on. */
  readonly left: number
  readonly right: number
  readonly top: number
  readonly bottom: number
  readonly across: LogScale
  readonly up: LogScale
  /** Below this line lies what is exact to rounding, if anything is. */
  readonly rounding: number | undefined
  /** Above this line lies what has no error, if anything has none. */
  readonly failed: number | undefined
  readonly drawn: readonly Drawn[]
  /** The runners of the lab whose methods are drawn. */
  readonly rings: readonly DiagramSpot[]
  readonly frontier: readonly DiagramSpot[]
  /** There is room for the curves' names beside them. */
  readonly named: boolean
}

const LEFT = 58
const BOTTOM = 44
const NAMES = 196
const ROW = 15
const LABEL = 17

/** Lays the curves, and the runners of a lab among them, out in a picture of that size. */
export function layOutDiagram(
  curves: readonly DiagramCurve[],
  { width, height }: Pick<DiagramLayout, 'width' | 'height'>,
  runners: readonly DiagramPoint[] = [],
): DiagramLayout {
  const named = width >= 680
  const left = LEFT
  const right = width - (named ? NAMES : 14)
  const swept = curves.flatMap((curve) => curve.points)
  const ringed = curves.map(({ method, by }) =>
    runners.filter((each) => by === 'rate' && each.method === method),
  )
  const points = [...swept, ...ringed.flat()]
  const whole = points.filter((point) => point.whole)
  const seen = whole.filter(({ error }) => error > 0)
  const failing = points.some((point) => !point.whole)
  // A row for each method that comes down to rounding, so that none hides another.
  const precise = curves.filter(({ points }, i) =>
    [...points, ...ringed[i]!].some(({ whole, error }) => whole && error === 0),
  )
  const exact = [...new Set(precise.map(({ method }) => method))]
  const top = failing ? 34 : 12
  const bottom = height - BOTTOM
  const floor = exact.length > 0 ? bottom - 10 - ROW * exact.length : bottom
  const errors = seen.map(({ error }) => error)
  const high = 10 ** decadeAbove(Math.max(...errors, 1e-3))
  const low =
    exact.length > 0
      ? leastDifference(precise[0]!.scale)
      : 10 ** decadeBelow(Math.min(...errors, high / 100))
  const up = logScale(low, high, floor, top)
  const costs = points.map(({ cost }) => cost).filter((cost) => cost > 0 && cost < Infinity)
  const across = logScale(
    Math.min(...costs, 1e9) / 1.25,
    Math.max(...costs, 1) * 1.25,
    left + 6,
    right - 6,
  )
  const place = (curve: DiagramCurve, point: DiagramPoint): DiagramSpot => {
    const { whole, error, cost } = point
    const row = floor + 8 + ROW * (exact.indexOf(curve.method) + 0.5)
    const y = !whole ? top - 14 : error === 0 ? row : up.at(error)
    return { point, x: across.at(Math.max(cost, across.from)), y }
  }
  const placed = (rows: readonly (readonly DiagramPoint[])[]) =>
    rows.map((points, i) => points.map((point) => place(curves[i]!, point)))
  const spots = placed(curves.map(({ points }) => points))
  const all = spots.flat()
  const best = frontier(swept.filter(({ whole, cost }) => whole && cost > 0))
  // A method is named once, at the end of its curve by rate.
  const isNamed = curves.map(({ by }) => by === 'rate')
  const labels = spread(
    spots.filter((_, i) => isNamed[i]).map((each) => each.at(-1)?.y ?? top),
    top + 4,
    bottom - 4,
  )[Symbol.iterator]()
  return {
    ...{ width, height, left, right, top, bottom, across, up, named },
    rounding: exact.length > 0 ? floor : undefined,
    failed: failing ? top : undefined,
    drawn: curves.map((curve, i) => ({
      ...{ curve, spots: spots[i]! },
      labelY: isNamed[i] ? labels.next().value : undefined,
    })),
    rings: placed(ringed).flat(),
    frontier: best.map((point) => all.find((spot) => spot.point === point)!),
  }
}

/** The spot that is nearest to a place, if one is near. */
export function nearestSpot(layout: DiagramLayout, x: number, y: number): DiagramSpot | undefined {
  let nearest: DiagramSpot | undefined
  let least = 28
  for (const spot of spotRows(layout).flat()) {
    const distance = Math.sqrt((spot.x - x) ** 2 + (spot.y - y) ** 2)
    if (distance < least) {
      least = distance
      nearest = spot
    }
  }
  return nearest
}

/** All spots as they are gone along: curve by curve, and then the runners of the lab. */
export function spotRows({ drawn, rings }: DiagramLayout): (readonly DiagramSpot[])[] {
  return [...drawn.map(({ spots }) => spots), ...(rings.length > 0 ? [rings] : [])]
}

/** Moves labels apart to a line's height each, in their order, within bounds. */
function spread(wanted: readonly number[], top: number, bottom: number): number[] {
  const order = wanted.map((_, i) => i).sort((a, b) => wanted[a]! - wanted[b]! || a - b)
  const placed = [...wanted]
  let above = top - LABEL
  for (const i of order) above = placed[i] = Math.max(placed[i]!, above + LABEL)
  let below = bottom + LABEL
  for (const i of order.reverse()) below = placed[i] = Math.min(placed[i]!, below - LABEL)
  return placed
}
