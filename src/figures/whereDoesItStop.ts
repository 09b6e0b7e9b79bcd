import type { Experiment, Trajectory } from '../physics/index.ts'
import { moved } from '../chart/geometry.ts'
import { line } from '../chart/graph.ts'
import { fixed } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { rowAt } from '../view/timeline.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { drawFlag, drawLongSlope, longSlope, drawBlock } from './shared/slope.ts'
import { roughly } from './shared/readings.ts'

/** How far up the slope one can bet [m], and how long all runs take [s]. */
const FAR = 6
const DURATION = 1.6
const RATES = [10, 30, 120] as const
const parameters = { angle: 10, muStatic: 0.4, muKinetic: 0.4, speed: -7 } as const

interface BetValues {
  readonly bet: number
  readonly phase: 'bet' | 'run'
}

/** A bet on where a block stops, before it runs. */
export const whereDoesItStop = figure({
  id: 'where-does-it-stop',
  title: 'Where will it stop?',
  pictured:
    'A block at the foot of a slope with a mark at every metre, and a flag where you bet that it will stop.',
  controls: {
    bet: { type: 'number', label: 'Your bet', unit: 'm', from: 0, to: FAR, step: 0.05, initial: 3 },
    phase: {
      type: 'choice',
      label: 'Phase',
      options: [
        { id: 'bet', label: 'Betting' },
        { id: 'run', label: 'Run' },
      ],
      initial: 'bet',
      hidden: true,
    },
  },
  experiments: (): Experiment[] => [
    { scene: 'ramp', parameters, duration: DURATION },
    ...RATES.map((fps): Experiment => ({
      scene: 'ramp',
      parameters,
      integrator: 'semi-implicit-euler',
      stopping: 'clamped',
      frames: { kind: 'steady', fps },
      duration: DURATION,
    })),
  ],
  duration: ({ phase }) => (phase === 'run' ? DURATION : 0),
  // Whoever moves the flag after the run bets anew.
  follow: (values, before) => (values.bet === before.bet ? values : { ...values, phase: 'bet' }),
  action: { label: () => 'Run', act: (values) => ({ ...values, phase: 'run' }) },
  panels: [
    {
      shape: { wide: 0.5, narrow: 0.86 },
      draw,
      grips: (size, { values }) => {
        const { at, slope, scale } = slopeIn(size)
        const flag = at(values.bet)
        const start = at(0)
        return [
          {
            control: 'bet',
            x: flag.x,
            y: flag.y - flagHeight(size),
            at: ({ x }) => (x - start.x) / (scale * -slope.along.x),
          },
        ]
      },
    },
  ],
  says: ({ bet, phase }, runs, time) => {
    if (phase === 'bet')
      return 'A kick of 7 m/s up a slope of 10°, μ = 0.4. Put the flag where it will stop, then press Run.'
    if (time < DURATION) return 'It runs …'
    const [truth, ...others] = runs.map(stopOf)
    const off = Math.abs(bet - truth!)
    const verdict = off < 0.05 ? 'You hit it' : `You were ${roughly(off)} off`
    const stops = RATES.map((fps, i) => `${fps} fps at ${fixed(others[i]!, 2)}`).join(', ')
    return `${verdict}: it stops at ${fixed(truth!, 2)} m. The usual code, a step a frame and a clamp at 0, would have settled your bet elsewhere: ${stops} m.`
  },
})

/** How far uphill a run ends [m]. */
function stopOf({ s }: Trajectory): number {
  return -s[s.length - 1]!
}

function slopeIn(size: Pick<DrawingSurface, 'width' | 'height'>) {
  return longSlope(size, parameters.angle, FAR, 0.3 * size.height)
}

function flagHeight({ height }: Pick<DrawingSurface, 'height'>): number {
  return 0.26 * height
}

function draw(surface: DrawingSurface, { values, runs, time }: View<BetValues>): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const long = slopeIn(surface)
  drawLongSlope(surface, long, FAR)
  const isRun = values.phase === 'run'
  const size = Math.min(44, 0.05 * width + 16)
  const [truth] = runs
  const block = (uphill: number) => ({
    middle: moved(long.at(uphill), long.slope.out, size / 2),
    angle: long.slope.angle,
  })
  const flag = long.at(values.bet)
  drawFlag(surface, flag, flagHeight(surface), palette.accent)
  context.font = `600 14px ${palette.sans}`
  context.fillStyle = palette.accentText
  const label = `your bet: ${fixed(values.bet, 2)} m`
  write(context, label, flag.x, flag.y - flagHeight(surface) - 16, {
    align: values.bet > 0.8 * FAR ? 'right' : 'center',
    halo: palette.sheet,
  })
  const uphill = isRun ? -truth!.drawnS[rowAt(truth!, time)]! : 0
  const { middle, angle } = block(uphill)
  if (isRun && time >= DURATION) drawStops(surface, runs, (s) => long.at(s))
  context.strokeStyle = palette.ink
  drawBlock(context, middle, { angle, size, fill: palette.inkSoft })
}

/** Where the frame rates stop, under the slope, each on a line of its own. */
function drawStops(
  surface: DrawingSurface,
  [, ...runs]: readonly Trajectory[],
  at: (uphill: number) => { x: number; y: number },
): void {
  const { context, palette } = surface
  context.font = `500 13px ${palette.sans}`
  const low = 42 + Math.max(...runs.map((run) => at(stopOf(run)).y))
  runs.forEach((run, i) => {
    const place = at(stopOf(run))
    const { fill, text } = palette.runners[i]!
    const y = low + 20 * i
    context.strokeStyle = fill
    context.lineWidth = 2
    line(context, { x: place.x, y: place.y - 10 }, { x: place.x, y })
    line(context, { x: place.x, y }, { x: place.x - 8, y })
    context.fillStyle = text
    const words = `${RATES[i]} fps: ${fixed(stopOf(run), 2)} m`
    write(context, words, place.x - 12, y + 4, { align: 'right', halo: palette.ground })
  })
}
