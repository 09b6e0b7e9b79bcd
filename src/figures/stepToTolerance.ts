import type { Experiment, Trajectory } from '../physics/index.ts'
import { exactMotion } from '../physics/index.ts'
import { trajectoryErrors } from '../measure/index.ts'
import { dot, drawAxes, drawCurve, graphIn } from '../chart/graph.ts'
import { roughSize, sizeText } from '../chart/magnitudes.ts'
import { count, seconds } from '../chart/numbers.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { stepsOf } from './shared/readings.ts'

const DURATION = 2

interface ToleranceValues {
  readonly exponent: number
}

/** A dive in steps that the error asks for: many where the stone is quick, few where it sinks steadily. */
export const stepToTolerance = figure({
  id: 'step-to-tolerance',
  title: 'As many steps as the error asks for',
  pictured:
    'The depth of a stone that dives into water, with a dot at the end of each step, and below it a bar for each step, as tall as the step is long. The bars are short at first, where the water brakes the stone, and longer the more steadily it sinks.',
  controls: {
    exponent: {
      type: 'number',
      label: 'Power of ten',
      symbol: 'n',
      from: -9,
      to: -3,
      step: 1,
      initial: -4,
    },
  },
  experiments: ({ exponent }): Experiment[] => [
    {
      scene: 'fall',
      parameters: { drag: 2, speed: 12, position: 0 },
      integrator: 'rk4',
      timestep: { kind: 'tolerance', tolerance: toleranceOf(exponent) },
      // Frames so long that they cut hardly any step.
      frames: { kind: 'steady', fps: 1 },
      duration: DURATION,
    },
  ],
  panels: [
    { shape: { wide: 0.32, narrow: 0.62 }, draw: drawPath },
    { shape: { wide: 0.26, narrow: 0.5 }, draw: drawSteps },
  ],
  says: ({ exponent }, [run]) => {
    const lengths = lengthsOf(run!)
    const [short, long] = [Math.min(...lengths), Math.max(...lengths)]
    const largest = trajectoryErrors(run!).largest
    return `For ${roughSize(toleranceOf(exponent))} a second, Runge–Kutta 4 keeps ${count(lengths.length)} steps of ${seconds(short)} to ${seconds(long)}. They cost ${count(run!.evaluations)} evaluations, refused tries included, and are off by ${sizeText(largest)} at most.`
  },
})

/** The power of ten: by its decimal, since engines disagree about powers [m/s]. */
function toleranceOf(exponent: number): number {
  return Number(`1e${exponent}`)
}

/** How long each step lasted [s]. */
function lengthsOf(run: Trajectory): number[] {
  const times = stepsOf(run).map(({ time }) => time)
  return times.map((time, i) => time - (times[i - 1] ?? 0))
}

type Surface = View<ToleranceValues>

function drawPath(surface: DrawingSurface, { runs }: Surface): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const box = { left: 46, right: width - 22, top: 30, bottom: height - 26 }
  const run = runs[0]!
  const graph = graphIn(box, [0, DURATION], [1.05 * run.s[run.frames]!, 0])
  drawAxes(context, graph, { up: 'depth, m' }, palette)
  const { x, y } = graph
  const truth = exactMotion(run.experiment)
  const at = (time: number) => ({ x: x(time), y: y(truth(time, { s: 0, v: 0 }).s) })
  const times = Array.from({ length: 161 }, (_, i) => (DURATION * i) / 160)
  drawCurve(context, times.map(at), { colour: palette.inkSoft, width: 1.25 })
  context.fillStyle = palette.accent
  // The steps end on the curve, as far as anyone can see.
  for (const { time } of stepsOf(run)) dot(context, at(time), 3)
}

function drawSteps(surface: DrawingSurface, { runs }: Surface): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const lengths = lengthsOf(runs[0]!)
  const box = { left: 46, right: width - 22, top: 30, bottom: height - 28 }
  const top = 1.1 * Math.max(...lengths) * 1000
  const graph = graphIn(box, [0, DURATION], [0, top])
  drawAxes(context, graph, { across: 's', up: 'length of each step, ms' }, palette)
  const { x, y } = graph
  context.fillStyle = palette.accent
  let time = 0
  for (const length of lengths) {
    const left = x(time)
    const right = x((time += length))
    const high = y(1000 * length)
    context.fillRect(left, high, Math.max(0.5, right - left - 0.75), y(0) - high)
  }
}
