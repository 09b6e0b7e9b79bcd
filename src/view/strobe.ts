import type { Trajectory } from '../physics/index.ts'
import { clamp, moved } from './geometry.ts'
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

/** Draws every runner's dots in a lane of its own; those of frames still to come are faint. */
export function drawStrobe(
  context: CanvasRenderingContext2D,
  { runners, time, parameters }: Picture,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): void {
  runners.forEach((runner, lane) => {
    // Where lanes are close, so large that the next lane's dots are still seen.
    const radius = Math.min(dotRadius(runner.trajectory), 0.56 * layout.lanes.gap)
    const depth = layout.lanes.first + lane * layout.lanes.gap
    const dots = dotsOf(runner, depth, radius, layout, projection, JSON.stringify(parameters))
    const now = rowAt(runner.trajectory, time)
    let shown = dots.rows.findIndex((row) => row > now)
    if (shown < 0) shown = dots.rows.length
    context.fillStyle = palette.runners[runner.look]!.fill
    fillDots(context, dots, 0, shown, radius)
    context.globalAlpha = 0.32
    fillDots(context, dots, shown, dots.rows.length, radius)
    context.globalAlpha = 1
  })
}

/** The rarer the frames, the larger their dots: frame rates are seen at a glance. */
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
  { xs, ys }: Dots,
  from: number,
  to: number,
  radius: number,
): void {
  if (from >= to) return
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
