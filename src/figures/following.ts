import { decayRate, follow } from '../physics/damping.ts'
import { drawAxes, drawCurve, graphIn } from '../chart/graph.ts'
import { fixed } from '../chart/numbers.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { drawRateNames } from './shared/rateNames.ts'

const DURATION = 1
const rates = [30, 60, 120] as const
/** The instant that the sentence is about [s]. */
const LOOK = 0.2

interface FollowValues {
  readonly rule: 'per-frame' | 'exponential'
  readonly part: number
}

/** A camera that follows a target 1 m away, at three frame rates. */
export const following = figure({
  id: 'following',
  title: 'Smoothing at three frame rates',
  pictured:
    'The position over time of a camera that follows a target 1 m away, at 30, 60 and 120 frames a second.',
  controls: {
    rule: {
      type: 'choice',
      label: 'Part of the way',
      options: [
        { id: 'per-frame', label: 'the same each frame' },
        { id: 'exponential', label: '1 − exp(−k Δt)' },
      ],
      initial: 'per-frame',
    },
    part: {
      type: 'number',
      label: 'Part, at 60 fps',
      from: 0.02,
      to: 0.5,
      step: 0.02,
      initial: 0.1,
    },
  },
  experiments: () => [],
  panels: [{ shape: { wide: 0.42, narrow: 0.8 }, draw }],
  says: (values) => {
    const [at30, at60, at120] = rates.map((fps) =>
      fixed(100 * cameraPath(values, fps)[Math.round(LOOK * fps)]!, 0),
    )
    return `After ${fixed(LOOK, 1)} s the camera has gone ${at30!}\u202f% of the way at 30 frames a second, ${at60!}\u202f% at 60 and ${at120!}\u202f% at 120.`
  },
})

/** Where the camera is after every frame [m]. */
function cameraPath({ rule, part }: FollowValues, fps: number): readonly number[] {
  const k = decayRate(1 - part, 60)
  const path = [0]
  for (let frame = 0; frame < DURATION * fps; frame++) {
    const x = path.at(-1)!
    path.push(rule === 'per-frame' ? x + (1 - x) * part : follow(x, 1, k, 1 / fps))
  }
  return path
}

function draw(surface: DrawingSurface, { values }: View<FollowValues>): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const box = { left: 52, right: width - 22, top: 28, bottom: height - 28 }
  const graph = graphIn(box, [0, DURATION], [0, 1.1])
  drawAxes(context, graph, { across: 's', up: 'camera, m' }, palette)
  rates.forEach((fps, i) => {
    const points = cameraPath(values, fps).map((x, row) => ({
      x: graph.x(row / fps),
      y: graph.y(x),
    }))
    drawCurve(context, points, { colour: palette.runners[i]!.fill, width: 2 })
  })
  drawRateNames(surface, box, rates)
}
