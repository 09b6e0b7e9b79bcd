import type { Trajectory } from '../../physics/index.ts'
import { cleared } from '../../chart/pen.ts'
import { rowAt } from '../../view/timeline.ts'
import {
  clockworkOf,
  hasOwnSteps,
  onTheWall,
  stepTimes,
  triedTimes,
} from '../../lab/state/clockwork.ts'

/** A stretch of time on a canvas [s], all else in its own pixels. */
export interface StripAxis {
  readonly from: number
  readonly to: number
  readonly width: number
  /** Of the window. */
  readonly ratio: number
}

/** Where on the canvas a runner's ticks are, and under them its steps if it has any. */
export interface LaneBox {
  readonly top: number
  readonly tick: number
  readonly steps: number
}

interface LaneColours {
  readonly runner: string
  readonly line: string
  readonly wrong: string
}

/** Draws what a runner did with a stretch of time. */
export function drawLane(
  pen: CanvasRenderingContext2D,
  trajectory: Trajectory,
  axis: StripAxis,
  lane: LaneBox,
  colours: LaneColours,
): void {
  const { from, to, width, ratio } = axis
  const pixel = Math.max(1, Math.round(ratio))
  const scale = (width - ratio) / (to - from)
  const place = (time: number) => Math.round((time - from) * scale)
  const { time, step, tries, lost, accumulator } = clockworkOf(trajectory)
  const first = rowAt(trajectory, from)
  const last = Math.min(time.length - 1, rowAt(trajectory, to) + 1)
  const { top, tick } = lane
  pen.fillStyle = colours.line
  pen.fillRect(0, Math.round(top + tick / 2), width, Math.max(1, Math.floor(ratio)))

  if (lost[last]! > 0) {
    pen.fillStyle = hatch(pen, colours.wrong, ratio)
    for (let row = Math.max(1, first); row <= last; row++) {
      const dropped = (lost[row]! - lost[row - 1]!) / trajectory.experiment.timeScale
      if (dropped <= 0) continue
      const x = place(Math.max(time[row - 1]!, time[row]! - dropped))
      pen.fillRect(x, top, Math.max(pixel, place(time[row]!) - x), tick)
    }
  }

  pen.fillStyle = colours.runner
  // Where frames are denser than pixels, each column counts once.
  for (const x of once(time.subarray(first, last + 1), place)) pen.fillRect(x, top, pixel, tick)

  if (!hasOwnSteps(trajectory)) return
  const stepTick = Math.round(0.4 * lane.steps)
  const stepTop = Math.round(top + tick + 2 * ratio)
  const bottom = stepTop + lane.steps
  const ticks = (times: Iterable<number>, y: number) => {
    for (const x of once(times, place))
      if (x >= 0 && x <= width) pen.fillRect(x, y, pixel, stepTick)
  }
  if (step === undefined ? !tries : step * scale < 2 * pixel) {
    const end = place(onTheWall(trajectory, trajectory.stateTime[last]! + lost[last]!))
    pen.fillRect(place(from), stepTop, end - place(from), stepTick)
  } else if (tries) {
    ticks(triedTimes(trajectory, tries, true), stepTop)
    // Under those that were kept, those that were taken back.
    pen.globalAlpha = 0.4
    ticks(triedTimes(trajectory, tries, false), bottom - stepTick)
    pen.globalAlpha = 1
  } else ticks(stepTimes(trajectory, first, last), stepTop)
  if (step === undefined) return
  pen.globalAlpha = 0.55
  for (let row = first; row <= last; row++) {
    const height = Math.round((accumulator[row]! / step) * (lane.steps - stepTick))
    if (height === 0) continue
    const x = place(time[row]!)
    const end = row + 1 < time.length ? place(time[row + 1]!) : x + pixel
    if (end > x) pen.fillRect(x, bottom - height, end - x, height)
  }
  pen.globalAlpha = 1
}

function* once(times: Iterable<number>, place: (time: number) => number): Generator<number> {
  let last = NaN
  for (const time of times) {
    const x = place(time)
    if (x !== last) yield x
    last = x
  }
}

const hatches = new Map<string, CanvasPattern>()

function hatch(pen: CanvasRenderingContext2D, colour: string, ratio: number): CanvasPattern {
  const key = `${colour} ${ratio}`
  const known = hatches.get(key)
  if (known) return known
  const size = Math.round(4 * ratio)
  const tile = document.createElement('canvas')
  tile.width = tile.height = size
  const context = tile.getContext('2d')!
  context.strokeStyle = colour
  context.lineWidth = 1.2 * ratio
  context.beginPath()
  // Thrice, so that the corners are as dark as the rest.
  for (const shift of [-size, 0, size]) {
    context.moveTo(shift - 1, size + 1)
    context.lineTo(shift + size + 1, -1)
  }
  context.stroke()
  const pattern = pen.createPattern(tile, 'repeat')!
  hatches.set(key, pattern)
  return pattern
}

/** Where the cursor on time is, on a canvas over a strip and the slider above it [px]. */
interface Playhead {
  /** Of the canvas: it reaches beyond the strip's ends by half of the slider's thumb. */
  readonly width: number
  readonly height: number
  /** Of the strip. */
  readonly length: number
  readonly depth: number
  /** From the strip's beginning. */
  readonly at: number
  /** Whether it moves: then the slider leaves its thumb to this canvas. */
  readonly moves: boolean
}

/**
 * Draws the cursor on time. On a canvas, since to move a part of the page, or the thumb of a slider, has the browser work
 * out anew what lies above what: that takes longer than to draw all of this.
 */
export function drawPlayhead(
  canvas: HTMLCanvasElement,
  { width, height, length, depth, at, moves }: Playhead,
  { accent, sheet }: { readonly accent: string; readonly sheet: string },
): void {
  const pen = cleared(canvas, width, height)
  const half = (width - length) / 2
  const top = height - depth
  const x = half + at
  pen.fillStyle = pen.strokeStyle = accent
  // On a whole pixel of the screen: between two it would be a blur of both.
  pen.fillRect(Math.round(x * devicePixelRatio) / devicePixelRatio, top, 1, depth)
  if (!moves) return
  pen.fillRect(0, Math.round(top / 2 - 1.5), x, 3)
  pen.beginPath()
  pen.arc(x, top / 2, half - 1, 0, 2 * Math.PI)
  pen.fillStyle = sheet
  pen.fill()
  pen.lineWidth = 2
  pen.stroke()
}
