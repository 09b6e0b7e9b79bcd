import type { Trajectory } from '../physics/index.ts'
import { clamp, moved } from '../chart/geometry.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture, PictureRunner } from './picture.ts'
import type { Projection } from './projection.ts'
import { frameRate, rowAt } from './timeline.ts'

/** A dot a frame, below the track. What one trajectory's dots look like through one camera is kept. */
interface Dots {
  readonly key: string
  readonly rows: readonly number[]
  readonly xs: readonly number[]
  readonly ys: readonly number[]
}
const kept = new WeakMap<Trajectory, Dots>()

/**
 * The rows that show something new: each the first to fall into its cell, where the track between two ends is cut
 * into cells. Rows outside are left out.
 */
export function thin(s: ArrayLike<number>, from: number, to: number, cell: number): number[] {
  const cells = Math.max(1, Math.ceil((to - from) / cell))
  const taken = new Uint8Array(cells)
  const rows: number[] = []
  for (let row = 0; row < s.length; row++) {
    const place = s[row]!
    if (!(place >= from && place <= to)) continue
    const i = Math.min(cells - 1, Math.floor((place - from) / cell))
    if (taken[i] === 1) continue
    taken[i] = 1
    rows.push(row)
  }
  return rows
}

/** One runner's dots, in a lane of its own. */
export interface Lane extends Dots {
  readonly trajectory: Trajectory
  readonly radius: number
  readonly fill: string
}

/** The number of a lane's dots that are drawn at once and then kept. */
const BATCH = 32

/** A full batch of a lane's dots, which is drawn as soon as its last frame has been shown. */
export interface Batch {
  readonly lane: Lane
  readonly from: number
  /** The row of its last frame. */
  readonly last: number
}

/** The lanes of all runners. */
export function lanesOf(
  { runners, parameters }: Picture,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): Lane[] {
  const key = JSON.stringify(parameters)
  return runners.map((runner, i) => {
    // Where lanes are close, so large that the next lane's dots are still seen.
    const radius = Math.min(dotRadius(runner.trajectory), 0.56 * layout.lanes.gap)
    const depth = layout.lanes.first + i * layout.lanes.gap
    const dots = dotsOf(runner, depth, radius, layout, projection, key)
    const { fill } = palette.runners[runner.paletteIndex]!
    return { ...dots, trajectory: runner.trajectory, radius, fill }
  })
}

/**
 * All full batches in the order of time: whoever draws them in this order gets the same pixels, at once or by and by.
 */
export function batchesOf(lanes: readonly Lane[]): Batch[] {
  const timeOf = ({ lane, last }: Batch) => lane.trajectory.time[last]!
  return lanes
    .flatMap((lane) =>
      Array.from({ length: Math.floor(lane.rows.length / BATCH) }, (_, i): Batch => {
        const from = i * BATCH
        return { lane, from, last: lane.rows[from + BATCH - 1]! }
      }),
    )
    .sort((a, b) => timeOf(a) - timeOf(b))
}

/** The frames of all times, faint. */
export function drawFaint(context: CanvasRenderingContext2D, lanes: readonly Lane[]): void {
  context.globalAlpha = 0.32
  for (const lane of lanes) fillDots(context, lane, 0, lane.rows.length)
  context.globalAlpha = 1
}

export function drawBatch(context: CanvasRenderingContext2D, { lane, from }: Batch): void {
  fillDots(context, lane, from, from + BATCH)
}

/** The latest dots of every lane by then: those that don't make up a full batch. */
export function drawLatest(
  context: CanvasRenderingContext2D,
  lanes: readonly Lane[],
  time: number,
): void {
  for (const lane of lanes) {
    const now = rowAt(lane.trajectory, time)
    const shown = countUpTo(lane.rows, now)
    fillDots(context, lane, shown - (shown % BATCH), shown)
  }
}

/** How many dots there are by then. */
export function countDots(lanes: readonly Lane[], time: number): number {
  return lanes.reduce(
    (sum, { rows, trajectory }) => sum + countUpTo(rows, rowAt(trajectory, time)),
    0,
  )
}

/** How many of the numbers, which are in order, are not above a limit. */
function countUpTo(numbers: readonly number[], limit: number): number {
  let low = 0
  let high = numbers.length
  while (low < high) {
    const middle = (low + high) >> 1
    if (numbers[middle]! <= limit) low = middle + 1
    else high = middle
  }
  return low
}

/** Dots are larger at lower frame rates, so that rates can be told at a glance. */
function dotRadius(trajectory: Trajectory): number {
  return clamp(1 + 8 / Math.sqrt(Math.max(1, frameRate(trajectory))), 1.2, 3.6)
}

function dotsOf(
  { trajectory }: PictureRunner,
  depth: number,
  radius: number,
  { extent, camera, width, height }: Layout,
  projection: Projection,
  parameters: string,
): Dots {
  const { scale, x, y } = camera
  const key = [scale, x, y, width, height, depth, parameters].join()
  const known = kept.get(trajectory)
  if (known?.key === key) return known
  // Dots that touch are a line already.
  const rows = thin(trajectory.drawnS, extent.from, extent.to, radius / scale)
  const points = rows.map((row) => {
    const spot = projection.at(trajectory.drawnS[row]!)
    return moved(spot, spot.out, -depth)
  })
  const dots = { key, rows, xs: points.map((p) => p.x), ys: points.map((p) => p.y) }
  kept.set(trajectory, dots)
  return dots
}

function fillDots(
  context: CanvasRenderingContext2D,
  { xs, ys, radius, fill }: Lane,
  from: number,
  to: number,
): void {
  if (from >= to) return
  context.fillStyle = fill
  context.beginPath()
  // So small a square cannot be told from a disc, and is much quicker to fill.
  const small = radius < 1.8
  const half = 0.9 * radius
  for (let i = from; i < to; i++) {
    const x = xs[i]!
    const y = ys[i]!
    if (small) context.rect(x - half, y - half, 2 * half, 2 * half)
    else {
      context.moveTo(x + radius, y)
      context.arc(x, y, radius, 0, 2 * Math.PI)
    }
  }
  context.fill()
}
