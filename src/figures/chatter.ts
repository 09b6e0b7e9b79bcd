import { exact } from '../physics/index.ts'
import type { Experiment, Trajectory } from '../physics/index.ts'
import type { Box } from '../chart/geometry.ts'
import { clipTo, dot, drawAxes, drawCurve, graphIn } from '../chart/graph.ts'
import type { Graph } from '../chart/graph.ts'
import { fixed, seconds } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { roughly } from './shared/readings.ts'

const DURATION = 1.5
const scene = {
  scene: 'ramp',
  parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  duration: DURATION,
} as const
/** The true block's stop [s]: v = 0 at 5 / (g (sin α + μ cos α)). */
const STOP = 5 / (9.81 * (Math.sin(Math.PI / 12) + 0.5 * Math.cos(Math.PI / 12)))

interface StopValues {
  readonly fps: number
  readonly stopping: 'naive' | 'clamped' | 'located'
}

/** The kicked block's velocity near its stop, under each stopping rule. */
export const chatter = figure({
  id: 'chatter',
  title: 'The velocity near its stop',
  pictured:
    'The velocity of the kicked block over time, a dot for every frame, and enlarged below it what happens around its stop.',
  controls: {
    fps: rateControl(30),
    stopping: {
      type: 'choice',
      label: 'Friction',
      options: [
        { id: 'naive', label: 'against the sign of v' },
        { id: 'clamped', label: 'clamped at 0' },
        { id: 'located', label: 'located' },
      ],
      initial: 'naive',
    },
  },
  experiments: ({ fps, stopping }): Experiment[] => [
    {
      ...scene,
      integrator: stopping === 'located' ? 'velocity-verlet' : 'semi-implicit-euler',
      stopping,
      frames: { kind: 'steady', fps },
    },
  ],
  panels: [
    { shape: { wide: 0.2, narrow: 0.36 }, draw: drawWhole },
    { shape: { wide: 0.36, narrow: 0.7 }, draw: drawNear },
  ],
  says: ({ fps, stopping }, [run]) => {
    const turns = turnsOf(run!)
    const off = roughly(Math.abs(run!.s[run!.frames]! - exact(scene, DURATION).s))
    if (stopping === 'naive')
      return `The velocity jumps over 0 and back, ${turns} times by ${fixed(DURATION, 1)} s, and never is 0: the block trembles, and has crept to ${off} from where it should rest.`
    const { kind, time } = run!.outcome
    if (kind !== 'at-rest') return 'It is still on its way.'
    return stopping === 'clamped'
      ? `The step that would turn it round ends at rest, at the end of a frame, after ${seconds(time)}: quiet, but ${off} off, and at another frame rate it is another place.`
      : `Inside a frame, after ${seconds(time)}, the velocity is exactly 0, and there it stays: ${off} off at ${fps} fps, as at any other.`
  },
})

/** How often the velocity changes sign. */
export function turnsOf({ v }: Trajectory): number {
  let turns = 0
  for (let row = 1; row < v.length; row++) if (v[row]! * v[row - 1]! < 0) turns++
  return turns
}

/** The stretch that is enlarged: some frames on both sides of the stop, [s] and [m/s]. */
function near(fps: number) {
  const frame = 1 / fps
  const most = 8.2 * frame
  return {
    from: Math.max(0, STOP - 4 * frame),
    to: Math.min(DURATION, STOP + 12 * frame),
    low: -most * 0.9,
    high: most * 1.15,
  }
}

function drawWhole(surface: DrawingSurface, { values, runs }: View<StopValues>): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const box = boxIn(surface)
  const graph = graphIn(box, [0, DURATION], [-5, 1.5])
  drawAxes(context, graph, { across: 's', up: 'velocity, m/s; downhill is plus' }, palette)
  const { from, to, low, high } = near(values.fps)
  context.fillStyle = palette.accent
  context.globalAlpha = 0.14
  const [top, bottom] = [graph.y(Math.min(1.5, high)), graph.y(Math.max(-5, low))]
  context.fillRect(graph.x(from), top, graph.x(to) - graph.x(from), bottom - top)
  context.globalAlpha = 1
  drawRun(surface, graph, runs[0]!, 2)
}

function drawNear(surface: DrawingSurface, { values, runs }: View<StopValues>): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const { from, to, low, high } = near(values.fps)
  const graph = graphIn(boxIn(surface), [from, to], [low, high])
  context.save()
  context.fillStyle = palette.accent
  context.globalAlpha = 0.06
  context.fillRect(0, 0, width, height)
  context.restore()
  drawAxes(context, graph, { across: 's', up: 'enlarged' }, palette)
  drawRun(surface, graph, runs[0]!, 4.5)
  const { outcome } = runs[0]!
  if (outcome.kind !== 'at-rest') return
  context.font = `600 13px ${palette.sans}`
  context.fillStyle = palette.ink
  write(context, 'at rest', graph.x(outcome.time), graph.y(0) - 12, { halo: palette.sheet })
}

function boxIn({ width, height }: DrawingSurface): Box {
  return { left: 52, right: width - 22, top: 28, bottom: height - 28 }
}

/** The exact velocity, and a run's, which jumps at every frame. */
function drawRun(
  { context, palette }: DrawingSurface,
  graph: Graph,
  run: Trajectory,
  size: number,
): void {
  const { box } = graph
  context.save()
  clipTo(context, { ...box, left: box.left - 4, right: box.right + 4 })
  const { from, to } = graph.across
  const truth = [0, STOP, DURATION].map((t) => ({ x: graph.x(t), y: graph.y(exact(scene, t).v) }))
  drawCurve(context, truth, { colour: palette.ink, width: 1.5, dash: [6, 4] })
  const rows = Array.from(run.time.keys()).filter(
    (row) =>
      run.time[Math.min(row + 1, run.frames)]! >= from && run.time[Math.max(0, row - 1)]! <= to,
  )
  const { fill } = palette.runners[0]!
  const points = rows.map((row) => ({ x: graph.x(run.time[row]!), y: graph.y(run.v[row]!) }))
  const { kind, time } = run.outcome
  // A stop inside a frame is a corner of the line.
  const stop = kind === 'at-rest' ? [{ x: graph.x(time), y: graph.y(0) }] : []
  const all = [...points, ...stop].sort((a, b) => a.x - b.x)
  drawCurve(context, all, { colour: fill, width: 1.5 })
  context.fillStyle = fill
  for (const point of points) dot(context, point, size)
  context.restore()
}
