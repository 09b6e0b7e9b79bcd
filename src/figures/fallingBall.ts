import { exactMotion } from '../physics/index.ts'
import type { Experiment } from '../physics/index.ts'
import { clipTo, dot, drawAxes, drawCurve, graphIn, line } from '../chart/graph.ts'
import { place, plain, seconds } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { rowAt } from '../view/timeline.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { roughly } from './shared/readings.ts'

/** How long it falls [s], and as deep as the picture goes [m]. */
const DURATION = 1
const DEPTH = 6
/** What a frame is worth to a game that does not ask how long it took [s]. */
const STEP = 1 / 60

interface FallValues {
  readonly fps: number
  readonly method: 'per-frame' | 'variable'
}

/** The paper's ball, moved once a frame: with and without delta time. */
export const fallingBall = figure({
  id: 'falling-ball',
  title: 'A ball that falls by frames',
  pictured:
    'A ball falls beside the true one; to the right, how far each has fallen over time, a dot for every frame.',
  controls: {
    fps: rateControl(15),
    method: {
      type: 'choice',
      label: 'Every frame',
      options: [
        { id: 'per-frame', label: 'moves it by the same amount' },
        { id: 'variable', label: 'times delta time' },
      ],
      initial: 'per-frame',
    },
  },
  experiments: ({ fps, method }): Experiment[] => [
    {
      scene: 'fall',
      integrator: 'semi-implicit-euler',
      timestep: method === 'variable' ? { kind: 'variable' } : { kind: 'per-frame', step: STEP },
      frames: { kind: 'steady', fps },
      duration: DURATION,
    },
  ],
  duration: () => DURATION,
  panels: [{ shape: { wide: 0.52, narrow: 0.86 }, draw }],
  says: ({ fps, method }, [run], time) => {
    const row = rowAt(run!, time)
    const fallen = run!.drawnS[row]!
    const truth = exactMotion(run!.experiment)(time, { s: 0, v: 0 }).s
    const so = `After ${seconds(time)} at ${fps} fps it has fallen ${place(fallen)}; the true ball has fallen ${place(truth)}.`
    if (method === 'variable')
      return `${so} Delta time has mended the clock; the ${roughly(Math.abs(fallen - truth))} that are left are the method’s.`
    const rate = fps * STEP
    if (Math.abs(rate - 1) < 0.005)
      return `${so} At 60 fps, and at no other, the game runs as it was made.`
    return `${so} Its clock runs ${rate < 1 ? `${times(1 / rate)} too slow` : `${times(rate)} too fast`}.`
  },
})

/** “2.5 times”, or “8.3 %” where it is little more than once. */
function times(rate: number): string {
  return rate < 1.1 ? `${plain(100 * (rate - 1))}\u202f%` : `${Number(rate.toPrecision(2))} times`
}

function draw(surface: DrawingSurface, { values, runs, time }: View<FallValues>): void {
  const { context, width, height, palette } = surface
  const run = runs[0]!
  const exact = exactMotion(run.experiment)
  const { fill, text } = palette.runners[0]!
  const state = { s: 0, v: 0 }
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const column = Math.min(230, 0.34 * width)
  const top = 40
  const box = { left: column + 46, right: width - 22, top, bottom: height - 30 }
  const graph = graphIn(box, [0, DURATION], [DEPTH, 0])
  drawAxes(context, graph, { across: 's', up: 'fallen, m' }, palette)

  context.save()
  clipTo(context, { left: 0, right: width, top: 0, bottom: height })
  drawCurve(
    context,
    Array.from({ length: 61 }, (_, i) => {
      const t = (DURATION * i) / 60
      return { x: graph.x(t), y: graph.y(exact(t, state).s) }
    }),
    { colour: palette.ink, width: 1.5 },
  )
  context.save()
  clipTo(context, { ...box, left: box.left - 8, right: box.right + 8, top: 0, bottom: height })
  const now = rowAt(run, time)
  const radius = values.fps > 60 ? 2.4 : 3.6
  run.time.forEach((t, row) => {
    context.globalAlpha = row <= now ? 1 : 0.28
    context.fillStyle = fill
    dot(context, { x: graph.x(t), y: graph.y(run.drawnS[row]!) }, radius)
  })
  context.globalAlpha = 1
  context.restore()
  context.strokeStyle = palette.accent
  context.lineWidth = 1
  line(context, { x: graph.x(time), y: top }, { x: graph.x(time), y: box.bottom })

  // The two balls beside each other, at the depth of the graph's axis.
  const size = Math.min(15, 0.1 * column + 3)
  const [left, right] = [0.3 * column, 0.72 * column]
  context.fillStyle = fill
  run.drawnS.forEach((s, row) => {
    if (row > now) return
    context.globalAlpha = row === now ? 1 : 0.13
    dot(context, { x: left, y: graph.y(s) }, size)
  })
  context.globalAlpha = 1
  context.strokeStyle = palette.ink
  context.lineWidth = 2
  run.time.forEach((t, row) => {
    if (row >= now) return
    context.globalAlpha = 0.13
    ring(surface, right, graph.y(exact(t, state).s), size)
  })
  context.globalAlpha = 1
  const truth = exact(time, state).s
  ring(surface, right, graph.y(truth), size)
  context.font = `600 13px ${palette.sans}`
  context.fillStyle = text
  write(context, `${values.fps} fps`, left, 18, { align: 'center' })
  context.fillStyle = palette.ink
  write(context, 'true', right, 18, { align: 'center' })
  const fallen = run.drawnS[now]!
  if (fallen > DEPTH) {
    context.fillStyle = text
    write(context, `↓ ${place(fallen)}`, left, height - 10, {
      align: 'center',
      halo: palette.sheet,
    })
  }
  context.restore()
}

function ring({ context }: DrawingSurface, x: number, y: number, radius: number): void {
  context.beginPath()
  context.arc(x, y, radius - 1, 0, 2 * Math.PI)
  context.stroke()
}
