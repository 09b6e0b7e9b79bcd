import type { Experiment, Timestep, Trajectory } from '../physics/index.ts'
import { presentationErrors } from '../measure/index.ts'
import { drawAxes, graphIn, line } from '../chart/graph.ts'
import { write } from '../chart/text.ts'
import { summarize, summaryText } from '../lab/state/frameTimes.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, FigureReading, View } from './shared/figure.ts'
import { kick } from './shared/kick.ts'
import { roughly } from './shared/readings.ts'

const DURATION = 1

/** The methods that the frames are tried on, from the paper's to the one that does not care. */
const tried: readonly { label: string; timestep: Timestep; located?: true }[] = [
  { label: 'Variable', timestep: { kind: 'variable' } },
  { label: 'Capped', timestep: { kind: 'capped', cap: 1 / 60 } },
  { label: 'Fixed', timestep: { kind: 'fixed', step: 1 / 60 } },
  { label: 'Verlet, located', timestep: { kind: 'variable' }, located: true },
]

/** Frames of 60 Hz as they are when a browser is busy, to begin with [s]. */
const SAMPLE = Array.from({ length: 240 }, (_, i) =>
  i % 60 === 41 ? 0.05 : i % 23 === 9 ? 0.0333 : 0.0167,
)

interface FramesValues {
  readonly frames: readonly number[]
}

/** The reader's own frames, through each method. */
export const yourFrames = figure({
  id: 'your-frames',
  title: 'Your own frames',
  pictured: 'A bar for every recorded frame, as high as it lasted.',
  controls: {
    frames: { type: 'frames', label: 'Frames', initial: SAMPLE },
  },
  experiments: ({ frames }): Experiment[] =>
    tried.map(({ timestep, located }) => ({
      ...kick,
      ...(located && { integrator: 'velocity-verlet', stopping: 'located' }),
      timestep,
      frames: { kind: 'recorded', durations: [...frames] },
      duration: DURATION,
    })),
  panels: [{ shape: { wide: 0.3, narrow: 0.55 }, draw }],
  says: ({ frames }) => {
    const whose = frames === SAMPLE ? 'A sample' : 'Your browser'
    return `${whose}: ${summaryText(frames)} Above, how far from the exact block each method draws a kick at worst.`
  },
  readings: (_, runs) =>
    tried.map(({ label }, i): FigureReading => {
      const worst = worstOf(runs[i]!)
      return { label, text: roughly(worst), raw: worst }
    }),
})

/** The largest error that a frame shows [m]. */
function worstOf(run: Trajectory): number {
  return presentationErrors(run).largest
}

function draw(surface: DrawingSurface, { values }: View<FramesValues>): void {
  const { context, width, height, palette } = surface
  const { frames } = values
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const { median, longest, total } = summarize(frames)
  const top = Math.max(2.4 * median, 1.05 * Math.min(longest, 8 * median)) * 1000
  const box = { left: 46, right: width - 22, top: 30, bottom: height - 28 }
  const graph = graphIn(box, [0, total], [0, top])
  drawAxes(context, graph, { across: 's', up: 'frame time, ms' }, palette)
  const { x, y } = graph
  let time = 0
  for (const frame of frames) {
    const isLong = frame > 1.5 * median
    context.fillStyle = isLong ? palette.wrong : palette.accent
    const [left, right] = [x(time), x((time += frame))]
    const high = y(Math.min(1000 * frame, top))
    context.fillRect(left, high, Math.max(1, right - left - 0.5), y(0) - high)
  }
  context.strokeStyle = palette.ink
  context.lineWidth = 1
  context.setLineDash([5, 4])
  line(context, { x: box.left, y: y(1000 * median) }, { x: box.right, y: y(1000 * median) })
  context.setLineDash([])
  context.font = `500 12px ${palette.sans}`
  context.fillStyle = palette.ink
  write(context, 'median', box.right - 2, y(1000 * median) - 6, {
    align: 'right',
    halo: palette.sheet,
  })
}
