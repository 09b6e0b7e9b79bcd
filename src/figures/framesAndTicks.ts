import { exactMotion } from '../physics/index.ts'
import type { Experiment, FramesChoice, Timestep, Trajectory } from '../physics/index.ts'
import { presentationErrorSizes } from '../measure/index.ts'
import { moved } from '../chart/geometry.ts'
import type { Box } from '../chart/geometry.ts'
import { clipTo, dot, drawAxes, drawCurve, graphIn, line } from '../chart/graph.ts'
import type { Graph } from '../chart/graph.ts'
import { seconds } from '../chart/numbers.ts'
import { widthOf, write } from '../chart/text.ts'
import { rowAt } from '../view/timeline.ts'
import { clockworkOf } from '../lab/state/clockwork.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { policies } from './shared/kick.ts'
import type { PolicyId } from './shared/kick.ts'
import { stepsOf, roughly } from './shared/readings.ts'

const DURATION = 0.6

interface TickValues {
  readonly timestep: PolicyId
  readonly fps: number
  readonly step: number
  readonly draw: 'latest' | 'interpolated' | 'extrapolated'
  readonly clock: 'steady' | 'jitter' | 'hitch' | 'missed-vsync'
}

/** What a game does with the time of its frames. */
export const framesAndTicks = figure({
  id: 'frames-and-ticks',
  title: 'Frames and physics steps',
  pictured:
    'Below, the instants of frames, of physics steps and what the accumulator holds; above, where each frame draws the block, beside the true motion.',
  controls: {
    fps: rateControl(24, 8, 90),
    step: {
      type: 'number',
      label: 'Step',
      symbol: 'Δt',
      unit: 's',
      from: 0.01,
      to: 0.1,
      step: 0.01,
      initial: 0.05,
    },
    timestep: { type: 'choice', label: 'Time step', options: policies, initial: 'fixed' },
    draw: {
      type: 'choice',
      label: 'Draws',
      options: [
        { id: 'latest', label: 'the latest state' },
        { id: 'interpolated', label: 'between two' },
        { id: 'extrapolated', label: 'ahead of it' },
      ],
      initial: 'interpolated',
    },
    clock: {
      type: 'choice',
      label: 'Frames',
      options: [
        { id: 'steady', label: 'steady' },
        { id: 'jitter', label: 'jitter' },
        { id: 'hitch', label: 'a hitch' },
        { id: 'missed-vsync', label: 'missed vsync' },
      ],
      initial: 'steady',
    },
  },
  experiments: ({ timestep, fps, step, draw, clock }): Experiment[] => [
    {
      scene: 'ramp',
      parameters: { angle: 15, muStatic: 0.3, muKinetic: 0.3, speed: -5 },
      timestep: policyOf(timestep, step, draw),
      frames: clockOf(clock, fps),
      duration: DURATION,
    },
  ],
  duration: () => DURATION,
  idle: ({ timestep }) =>
    timestep === 'fixed' ? [] : timestep === 'variable' ? ['step', 'draw'] : ['draw'],
  panels: [{ shape: { wide: 0.62, narrow: 1.27 }, draw }],
  says: ({ timestep, step }, [run]) => {
    const steps = `${run!.frames} frames, ${run!.steps} steps of physics.`
    const lag = roughly(presentationErrorSizes(run!).largest)
    const far = `At worst a frame draws the block ${lag} from where it is by then.`
    switch (timestep) {
      case 'variable':
        return `${steps} Every frame is one step, as long as the frame was. ${far}`
      case 'capped':
        return `${steps} No step is longer than ${seconds(step)}; of longer frames ${seconds(run!.lostTime)} in all are dropped, and the game runs late by that.`
      case 'substeps':
        return `${steps} A frame is cut into equal parts, none longer than ${seconds(step)}. ${far}`
      case 'fixed':
        return `${steps} Every step is ${seconds(step)} long; what is left of a frame waits in the accumulator. ${far}`
    }
  },
})

function policyOf(kind: PolicyId, step: number, draw: TickValues['draw']): Timestep {
  if (kind === 'variable') return { kind }
  if (kind === 'capped') return { kind, cap: step }
  return kind === 'substeps' ? { kind, step } : { kind, step, draw }
}

function clockOf(kind: TickValues['clock'], fps: number): FramesChoice {
  if (kind === 'steady') return { kind, fps }
  if (kind === 'jitter') return { kind, fps, amount: 0.7, seed: 3 }
  // Refreshes are missed in bursts: this seed has one within the first few frames.
  return kind === 'hitch' ? { kind, fps, every: 0.2, length: 0.15 } : { kind, fps, seed: 5 }
}

function draw(surface: DrawingSurface, { runs, time }: View<TickValues>): void {
  const { context, width, height, palette } = surface
  const run = runs[0]!
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const left = 96
  const right = width - 64
  // In a narrow graph the way up comes into every corner.
  const legend = right - left < 320 ? 'above' : 'inside'
  const box = { left, right, top: legend === 'above' ? 84 : 30, bottom: height - 158 }
  const graph = graphIn(box, [0, DURATION], [0, 2])
  drawAxes(context, graph, { across: 's', up: 'up the slope, m' }, palette)
  drawLegend(surface, graph, legend)
  drawMotion(surface, graph, run)
  const lanes = { frames: box.bottom + 40, ticks: box.bottom + 74, accumulator: box.bottom + 142 }
  drawLanes(surface, graph, run, lanes)
  const x = graph.x(time)
  context.strokeStyle = palette.accent
  context.lineWidth = 1.25
  line(context, { x, y: box.top }, { x, y: lanes.accumulator })
  drawBlocks(surface, graph, run, time)
}

/** The true motion, the physics states, and what the frames draw: each until the next one. */
function drawMotion({ context, palette }: DrawingSurface, graph: Graph, run: Trajectory): void {
  const { x, y, box } = graph
  const exact = exactMotion(run.experiment)
  context.save()
  clipTo(context, { ...box, right: box.right + 5, top: 0 })
  const truth = Array.from({ length: 81 }, (_, i) => {
    const t = (DURATION * i) / 80
    return { x: x(t), y: y(-exact(t, { s: 0, v: 0 }).s) }
  })
  drawCurve(context, truth, { colour: palette.ink, width: 1.5 })
  const { fill } = palette.runners[1]!
  const stairs = Array.from(run.time.keys()).flatMap((row) => {
    const at = y(-run.drawnS[row]!)
    const until = run.time[row + 1] ?? DURATION
    return [
      { x: x(run.time[row]!), y: at },
      { x: x(until), y: at },
    ]
  })
  drawCurve(context, stairs, { colour: fill, width: 1.25 })
  context.fillStyle = fill
  for (let row = 0; row <= run.frames; row++)
    dot(context, { x: x(run.time[row]!), y: y(-run.drawnS[row]!) }, 3.2)
  // A state of the physics at the time that it stands at.
  context.strokeStyle = palette.runners[0]!.fill
  context.lineWidth = 1.5
  for (let row = 0; row <= run.frames; row++) {
    context.beginPath()
    context.arc(x(run.stateTime[row]!), y(-run.s[row]!), 5, 0, 2 * Math.PI)
    context.stroke()
  }
  context.restore()
}

/** What is what in the graph: above it, or in its lower right corner, where the way up a slope does not come. */
function drawLegend(
  { context, palette }: DrawingSurface,
  { box }: Graph,
  place: 'above' | 'inside',
): void {
  const [drawn, physics] = [palette.runners[1]!, palette.runners[0]!]
  const rows = ['the true block', 'where the physics stands', 'what frames draw']
  const colours = [palette.ink, physics.text, drawn.text] as const
  context.font = `500 12px ${palette.sans}`
  const widest = Math.max(...rows.map((text) => widthOf(context, text)))
  const left = place === 'above' ? box.left + 20 : box.right - widest - 8
  const top = place === 'above' ? 0 : box.bottom - 64
  rows.forEach((text, i) => {
    context.fillStyle = colours[i]!
    write(context, text, left, top + 16 + 18 * i, { halo: palette.sheet })
  })
  const mark = (i: number) => ({ x: left - 13, y: top + 12 + 18 * i })
  context.strokeStyle = palette.ink
  context.lineWidth = 1.5
  line(context, moved(mark(0), { x: 1, y: 0 }, -7), moved(mark(0), { x: 1, y: 0 }, 7))
  context.strokeStyle = physics.fill
  context.beginPath()
  context.arc(mark(1).x, mark(1).y, 5, 0, 2 * Math.PI)
  context.stroke()
  context.fillStyle = drawn.fill
  dot(context, mark(2), 3.2)
}

/** One under the other: the frames, the steps, and what is left over after each frame. */
function drawLanes(
  { context, palette }: DrawingSurface,
  { x }: Graph,
  run: Trajectory,
  lanes: { readonly frames: number; readonly ticks: number; readonly accumulator: number },
): void {
  const [drawn, physics] = [palette.runners[1]!, palette.runners[0]!]
  const { accumulator, step, lost } = clockworkOf(run)
  const name = (text: string, y: number, colour: string) => {
    context.font = `500 12px ${palette.sans}`
    context.fillStyle = colour
    write(context, text, 84, y + 4, { align: 'right' })
  }
  name('frames', lanes.frames, drawn.text)
  for (let row = 1; row <= run.frames; row++) {
    const [from, to] = [x(run.time[row - 1]!), x(run.time[row]!)]
    context.fillStyle = drawn.fill
    context.globalAlpha = row % 2 ? 0.16 : 0.3
    context.fillRect(from, lanes.frames - 10, to - from, 20)
    context.globalAlpha = 1
    context.fillRect(to - 1, lanes.frames - 10, 2, 20)
    const dropped = lost[row]! - lost[row - 1]!
    if (dropped > 0) {
      context.fillStyle = palette.wrong
      context.globalAlpha = 0.55
      const begins = x(run.time[row]! - dropped)
      context.fillRect(begins, lanes.frames - 10, to - begins, 20)
      context.globalAlpha = 1
    }
  }
  name('steps', lanes.ticks, physics.text)
  context.strokeStyle = palette.edge
  context.lineWidth = 1
  line(context, { x: x(0), y: lanes.ticks }, { x: x(DURATION), y: lanes.ticks })
  context.fillStyle = physics.fill
  for (const { time, row } of stepsOf(run)) {
    const at = { x: x(time + lost[row - 1]!), y: lanes.ticks }
    dot(context, at, 4)
    // From the step up to the frame that took it.
    context.strokeStyle = physics.fill
    context.globalAlpha = 0.5
    line(context, { x: at.x, y: at.y - 4 }, { x: x(run.time[row]!), y: lanes.frames + 10 })
    context.globalAlpha = 1
  }
  name('accumulator', lanes.accumulator - 20, palette.ink)
  line(context, { x: x(0), y: lanes.accumulator }, { x: x(DURATION), y: lanes.accumulator })
  if (step === undefined) {
    context.fillStyle = palette.inkSoft
    write(context, 'only under “fixed”', x(0) + 8, lanes.accumulator - 16)
    return
  }
  context.setLineDash([4, 4])
  context.strokeStyle = palette.inkSoft
  const full = lanes.accumulator - 40
  line(context, { x: x(0), y: full }, { x: x(DURATION), y: full })
  context.setLineDash([])
  context.font = `11px ${palette.sans}`
  context.fillStyle = palette.inkSoft
  write(context, 'Δt', x(DURATION) + 6, lanes.accumulator - 36)
  context.fillStyle = physics.fill
  for (let row = 1; row <= run.frames; row++) {
    const high = (40 * accumulator[row]!) / step
    context.globalAlpha = 0.6
    context.fillRect(x(run.time[row]!) - 3, lanes.accumulator - high, 6, high)
    context.globalAlpha = 1
  }
}

/** The block as the present frame draws it, and the true one, beside the graph at its height. */
function drawBlocks(
  surface: DrawingSurface,
  { box, y }: Graph,
  run: Trajectory,
  time: number,
): void {
  const { context, palette } = surface
  const at = { x: box.right + 34, y: y(-run.drawnS[rowAt(run, time)]!) }
  const size = 24
  context.strokeStyle = palette.edge
  context.lineWidth = 1
  line(context, { x: at.x, y: box.top }, { x: at.x, y: box.bottom })
  const square = ({ left, top }: Pick<Box, 'left' | 'top'>) => {
    context.beginPath()
    context.roundRect(left, top, size, size, 3)
  }
  context.fillStyle = palette.runners[1]!.fill
  const corner = moved(at, { x: -1, y: -1 }, size / 2)
  square({ left: corner.x, top: corner.y })
  context.fill()
  const truth = y(-exactMotion(run.experiment)(time, { s: 0, v: 0 }).s)
  context.strokeStyle = palette.ink
  context.lineWidth = 2
  square({ left: at.x - size / 2, top: truth - size / 2 })
  context.stroke()
}
