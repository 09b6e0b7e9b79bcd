import { dampings, decay, framesOfCoasting } from '../physics/damping.ts'
import type { DampingId } from '../physics/damping.ts'
import { drawAxes, drawCurve, graphIn } from '../chart/graph.ts'
import { fixed, metres } from '../chart/numbers.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { drawRateNames } from './shared/rateNames.ts'

const DURATION = 1.5
const START = 5
const rates = [30, 60, 200] as const

interface CoastValues {
  readonly damping: DampingId
  readonly k: number
}

/** How far a damped body coasts at three frame rates. */
export const coasting = figure({
  id: 'coasting',
  title: 'Damping at three frame rates',
  pictured:
    'The position over time of a body that starts at 5 m/s and is damped, at 30, 60 and 200 frames a second, beside the true motion, dashed.',
  controls: {
    damping: {
      type: 'choice',
      label: 'v is multiplied by',
      options: dampings.map(({ id, formula }) => ({ id, label: formula })),
      initial: 'explicit',
    },
    k: {
      type: 'number',
      label: 'Damping',
      symbol: 'k',
      unit: '/s',
      from: 1,
      to: 30,
      step: 0.5,
      initial: 5,
    },
  },
  experiments: () => [],
  panels: [{ shape: { wide: 0.46, narrow: 0.9 }, draw }],
  says: (values) => {
    const [at30, at60, at200] = rates.map((fps) => metres(pathOf(values, fps).at(-1)!))
    const truth = (START / values.k) * (1 - decay(values.k * DURATION))
    return `After ${fixed(DURATION, 1)} s the body is at ${at30!} at 30 frames a second, ${at60!} at 60 and ${at200!} at 200; in truth it is at ${metres(truth)}.`
  },
})

function pathOf({ damping, k }: CoastValues, fps: number): readonly number[] {
  return framesOfCoasting(damping, { k, v: START, fps, frames: DURATION * fps })
}

function draw(surface: DrawingSurface, { values }: View<CoastValues>): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const box = { left: 52, right: width - 22, top: 28, bottom: height - 28 }
  const truth = (t: number) => (START / values.k) * (1 - decay(values.k * t))
  const paths = rates.map((fps) => pathOf(values, fps))
  const highest = Math.max(truth(DURATION), ...paths.flat())
  const graph = graphIn(box, [0, DURATION], [0, 1.1 * highest])
  drawAxes(context, graph, { across: 's', up: 'position, m' }, palette)
  paths.forEach((path, i) => {
    const points = path.map((x, row) => ({ x: graph.x(row / rates[i]!), y: graph.y(x) }))
    drawCurve(context, points, { colour: palette.runners[i]!.fill, width: 2 })
  })
  const exact = Array.from({ length: 151 }, (_, i) => ({
    x: graph.x(i / 100),
    y: graph.y(truth(i / 100)),
  }))
  drawCurve(context, exact, { colour: palette.ink, width: 1.5, dash: [6, 4] })
  drawRateNames(surface, box, rates)
}
