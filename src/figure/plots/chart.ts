import uPlot from 'uplot'
import { clamp } from '../../view/geometry.ts'
import type { Box } from '../../view/geometry.ts'
import { markPath } from '../../view/marks.ts'
import type { Palette } from '../../view/palette.ts'
import type { Axis, Tick } from './axis.ts'
import { EXACT } from './curves.ts'
import type { Curve, Drawing } from './curves.ts'

/** How a chart is drawn. */
export interface ChartLook {
  readonly palette: Palette
  /** The index of the runner whose curve is drawn stronger. */
  readonly selected: number
  /** [px] */
  readonly width: number
  readonly height: number
}

/** Room for the labels of the axes [px]. */
const LEFT = 66
const BOTTOM = 24

/** Between two marks on a curve [px]. */
const MARK_GAP = 30

/** On a curve that runs round and round. */
const MOST_MARKS = 24

/** A chart in an element, made once; all of its curves are replaced at a time. */
export class Chart {
  private readonly plot: uPlot
  private drawing: Drawing
  private look: ChartLook

  /** `drawn` is called whenever the chart has drawn itself. */
  constructor(host: HTMLElement, drawing: Drawing, look: ChartLook, drawn: () => void) {
    this.drawing = drawing
    this.look = look
    const axis = {
      stroke: () => this.look.palette.inkSoft,
      font: `11px ${look.palette.sans}`,
      grid: { stroke: () => this.look.palette.line, width: 1 },
      ticks: { show: false },
      gap: 6,
    }
    this.plot = new uPlot(
      {
        mode: 2,
        width: look.width,
        height: look.height,
        padding: [8, 14, 0, 0],
        legend: { show: false },
        cursor: { show: false },
        scales: {
          x: { time: false, range: () => ends(this.drawing.across) },
          y: { range: () => ends(this.drawing.up) },
        },
        axes: [
          { ...axis, ...chosen(() => this.ticks('across')), scale: 'x', size: BOTTOM },
          { ...axis, ...chosen(() => this.ticks('up')), scale: 'y', size: LEFT },
        ],
        series: [{}, ...Array.from({ length: EXACT + 1 }, (_, each) => this.series(each))],
        hooks: { drawSeries: [(_, i) => this.drawMarks(i - 1)], draw: [drawn] },
      },
      this.data(),
      host,
    )
    this.draw(drawing, look)
  }

  /** Draws something else. */
  draw(drawing: Drawing, look: ChartLook): void {
    const { plot } = this
    const { width, height } = look
    this.drawing = drawing
    this.look = look
    for (const { look: each, index } of drawing.curves)
      plot.series[each + 1]!.width = index === look.selected ? 2.25 : 1.4
    if (plot.width !== width || plot.height !== height) plot.setSize({ width, height })
    plot.setData(this.data())
  }

  /** The part of the element in which there are curves [px]. */
  get box(): Box {
    const { left, top, width, height } = this.plot.bbox
    const ratio = uPlot.pxRatio
    return {
      left: left / ratio,
      top: top / ratio,
      right: (left + width) / ratio,
      bottom: (top + height) / ratio,
    }
  }

  private ticks(along: 'across' | 'up'): Tick[] {
    const { left, right, top, bottom } = this.box
    return this.drawing[along].ticks(along === 'up' ? (bottom - top) / 28 : (right - left) / 48)
  }

  private series(look: number): uPlot.Series {
    const exact = look === EXACT
    return {
      auto: false,
      facets: [
        { scale: 'x', auto: false },
        { scale: 'y', auto: false },
      ],
      stroke: () => (exact ? this.look.palette.ink : this.look.palette.runners[look]!.fill),
      ...(exact && { dash: [5, 4] }),
      points: { show: false },
      paths: () => {
        const curve = this.curve(look)
        return curve ? { stroke: this.path(curve) } : null
      },
    }
  }

  private data(): uPlot.AlignedData {
    const series = Array.from({ length: EXACT + 1 }, (_, look) => {
      const curve = this.curve(look)
      return [curve?.x ?? [], curve?.y ?? []]
    })
    // uPlot's type knows only of charts whose curves share their x.
    return [null, ...series] as unknown as uPlot.AlignedData
  }

  private curve(look: number): Curve | undefined {
    return this.drawing.curves.find((curve) => curve.look === look)
  }

  /** A curve's line on the canvas, in steps where what is shown stays as it is until the next frame. */
  private path({ look, x, y }: Curve): Path2D {
    const path = new Path2D()
    const stepped = this.drawing.stepped && look !== EXACT
    for (let i = 0, before = 0; i < x.length; i++) {
      const [left, top] = this.spot(x[i]!, y[i]!)
      if (i > 0 && stepped) path.lineTo(left, before)
      path.lineTo(left, top)
      before = top
    }
    return path
  }

  /** Marks on frames of a runner's curve, far enough from each other to be told apart. */
  private drawMarks(look: number): void {
    const curve = this.curve(look)
    if (!curve || look === EXACT) return
    const { ctx, bbox } = this.plot
    const ratio = uPlot.pxRatio
    const { stepped } = this.drawing
    const spots = curve.x.map((x, i) => this.spot(x, curve.y[i]!))
    const far = (i: number, j: number) => {
      const [dx, dy] = [spots[i]![0] - spots[j]![0], spots[i]![1] - spots[j]![1]]
      return stepped ? dx : Math.hypot(dx, dy)
    }
    const seen = ([x, y]: readonly [number, number]) =>
      x >= bbox.left - 1 &&
      x <= bbox.left + bbox.width + 1 &&
      y >= bbox.top - 1 &&
      y <= bbox.top + bbox.height + 1
    let length = 0
    spots.forEach((spot, i) => {
      if (i > 0 && seen(spot)) length += Math.min(far(i, i - 1), bbox.width)
    })
    const gap = Math.max(MARK_GAP * ratio, length / MOST_MARKS)
    const radius = (curve.index === this.look.selected ? 4.5 : 3.5) * ratio
    ctx.fillStyle = this.look.palette.runners[look]!.fill
    // Not all at the same places, so that marks of curves that lie on each other are seen.
    let due = (gap * (look % 4)) / 4
    let last = 0
    spots.forEach((spot, i) => {
      if (far(i, last) < due) return
      last = i
      due = gap
      if (seen(spot)) ctx.fill(markPath(look, spot[0], spot[1], radius))
    })
  }

  /** A place on the canvas, in its pixels. Far outside it all places are alike: a canvas can't tell them apart either. */
  private spot(x: number, y: number): [number, number] {
    const { plot } = this
    const limit = (value: number) => clamp(value, -1e5, 1e5)
    return [limit(plot.valToPos(x, 'x', true)), limit(plot.valToPos(y, 'y', true))]
  }
}

function ends({ from, to }: Axis): [number, number] {
  return [from, to]
}

/** What an axis of uPlot needs for ticks that were chosen elsewhere. */
function chosen(list: () => Tick[]): uPlot.Axis {
  return {
    // A single step as long as the axis, so that uPlot looks for none; of those below 5 it knows only its own.
    incrs: (_, __, from, to) => [Math.max(5, to - from)],
    splits: () => list().map(({ at }) => at),
    values: () => list().map(({ label }) => label),
  }
}
