import type { Experiment, IntegratorId, Trajectory } from '../physics/index.ts'
import { trajectoryErrors } from '../measure/index.ts'
import { dot, drawCurve, graphIn, line } from '../chart/graph.ts'
import { count, metres } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { roughly } from './shared/readings.ts'

const DURATION = 10
const RATES = [10, 20, 40, 80, 160, 320] as const
/** The rate that the sentence is about. */
const TOLD = 2
const methods: readonly { readonly id: IntegratorId; readonly name: string }[] = [
  { id: 'explicit-euler', name: 'explicit Euler' },
  { id: 'semi-implicit-euler', name: 'semi-implicit Euler' },
  { id: 'velocity-verlet', name: 'Verlet' },
  { id: 'rk4', name: 'RK4' },
]

/** What each method costs and what it buys; the live one lets the reader choose. */
export const speedAgainstError = figure({
  id: 'speed-against-error',
  title: 'Speed against error',
  pictured:
    'For each method a line from few steps to many: to the right what it costs, upwards how far off it is. Euler’s lines fall gently, Verlet’s twice as steeply, RK4’s four times.',
  controls: {},
  experiments: (): Experiment[] =>
    methods.flatMap(({ id }) =>
      RATES.map((fps) => ({
        scene: 'half-pipe',
        integrator: id,
        frames: { kind: 'steady', fps },
        duration: DURATION,
      })),
    ),
  hosted: {
    tag: 'slide-speed-diagram',
    define: () => import('../panels/measures/speedDiagram.ts'),
    room: { wide: 16, narrow: 54 },
    properties: { experiment: { scene: 'half-pipe', duration: DURATION } satisfies Experiment },
  },
  panels: [{ shape: { wide: 0.56, narrow: 0.9 }, draw }],
  says: (_, runs) => {
    const words = methods.slice(1).map(({ name }, i) => {
      const run = runs[(i + 1) * RATES.length + TOLD]!
      return `${name} ${roughly(errorOf(run))} for ${count(costOf(run))} evaluations`
    })
    return `At ${RATES[TOLD]} steps a second in the half-pipe, off by at most: ${words.join(', ')} a second.`
  },
})

/** The largest error of a run, of all of it or as far as it went [m]. */
function errorOf(run: Trajectory): number {
  return trajectoryErrors(run).largest
}

/** Evaluations of the acceleration in a simulated second. */
function costOf({ evaluations, stateTime, frames }: Trajectory): number {
  return Math.round(evaluations / stateTime[frames]!)
}

function draw(surface: DrawingSurface, { runs }: View): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const box = { left: 62, right: width - 24, top: 34, bottom: height - 36 }
  // Powers of ten.
  const { x, y } = graphIn(box, [0.8, 3.8], [-10, 1])
  context.font = `12px ${palette.sans}`
  context.lineWidth = 1
  context.strokeStyle = palette.line
  for (let power = 1; power <= 3; power++) {
    line(context, { x: x(power), y: box.top }, { x: x(power), y: box.bottom })
    context.fillStyle = palette.inkSoft
    write(context, count(10 ** power), x(power), box.bottom + 16, { align: 'center' })
  }
  for (let power = -10; power <= 0; power += 2) {
    line(context, { x: box.left, y: y(power) }, { x: box.right, y: y(power) })
    context.fillStyle = palette.inkSoft
    write(context, metres(10 ** power), box.left - 8, y(power) + 4, { align: 'right' })
  }
  write(context, 'largest error', 12, 20)
  write(context, 'evaluations a second', box.right, box.bottom + 31, { align: 'right' })
  methods.forEach(({ name }, i) => {
    const { fill, text } = palette.runners[i]!
    const points = RATES.flatMap((_, rate) => {
      const run = runs[i * RATES.length + rate]!
      if (run.outcome.kind !== 'moving') return []
      return [{ x: x(Math.log10(costOf(run))), y: y(Math.log10(errorOf(run))) }]
    })
    drawCurve(context, points, { colour: fill, width: 1.75 })
    context.fillStyle = fill
    for (const point of points) dot(context, point, 4)
    const last = points[points.length - 1]
    if (!last) return
    context.font = `500 12px ${palette.sans}`
    context.fillStyle = text
    write(context, name, last.x + 10, last.y + 4, { halo: palette.sheet })
  })
}
