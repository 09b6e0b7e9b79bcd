import { length } from '../physics/index.ts'
import type { Experiment, Trajectory } from '../physics/index.ts'
import { moved } from '../chart/geometry.ts'
import { line } from '../chart/graph.ts'
import { fixed, place } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { rowAt } from '../view/timeline.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { longSlope, drawBlock, drawNamedArrows, drawSlope } from './shared/slope.ts'
import { angleControl, arrowFor, forcesOn, muControl } from './shared/tilted.ts'

const DURATION = 1.5
const FAR = 6
/** The block that is always the same [kg]. */
const LIGHT = 1

interface MassValues {
  readonly mass: number
  readonly angle: number
  readonly mu: number
}

/** A light and a heavy block, let go together. */
export const massCancels = figure({
  id: 'mass-cancels',
  title: 'A light block and a heavy one',
  pictured:
    'Two slopes alike, a light block on one and a heavy one on the other; they slide side by side.',
  controls: {
    mass: {
      type: 'number',
      label: 'Heavy block',
      symbol: 'm',
      unit: 'kg',
      from: 1,
      to: 50,
      step: 1,
      initial: 20,
    },
    angle: { ...angleControl(20), to: 30 },
    mu: { ...muControl(0.15), to: 0.6 },
  },
  experiments: ({ mass, angle, mu }): Experiment[] =>
    [LIGHT, mass].map((each) => ({
      scene: 'ramp',
      parameters: { angle, muStatic: mu, muKinetic: mu, mass: each },
      duration: DURATION,
    })),
  duration: () => DURATION,
  panels: [
    { shape: { wide: 0.27, narrow: 0.42 }, draw: (surface, view) => draw(surface, view, 0) },
    { shape: { wide: 0.27, narrow: 0.42 }, draw: (surface, view) => draw(surface, view, 1) },
  ],
  says: ({ mass }, runs, time) => {
    const [light, heavy] = runs.map((run) => run.s[rowAt(run, time)]!)
    const [a, b] = runs.map((run) => fixed(sumOn(run), 2))
    const same = light === heavy ? 'to the last digit' : 'to rounding'
    return `${a} N on ${LIGHT} kg, ${b} N on ${mass} kg: the same acceleration, since every force on a slope has the mass in it. Both have slid ${place(light!)}, ${same}.`
  },
})

function forcesIn({ experiment, s, v }: Trajectory, row = 0) {
  return forcesOn(experiment, { s: s[row]!, v: v[row]! })
}

function sumOn(run: Trajectory): number {
  return length(forcesIn(run).sum)
}

function draw(
  surface: DrawingSurface,
  { values, runs, time }: View<MassValues>,
  which: 0 | 1,
): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const run = runs[which]!
  const long = longSlope(surface, values.angle, FAR, 0.14 * height)
  drawSlope(context, long.slope, surface, palette)
  const mass = which === 0 ? LIGHT : values.mass
  const size = 16 + 0.05 * width * Math.cbrt(mass / 50)
  const row = rowAt(run, time)
  // From near the top down.
  const at = (s: number) => long.at(FAR - s)
  context.globalAlpha = 0.16
  const { fill, text } = palette.runners[which === 0 ? 4 : 1]!
  const { angle, out } = long.slope
  for (let each = 0; each < row; each += 15)
    drawBlock(context, moved(at(run.s[each]!), out, size / 2), { angle, size, fill })
  context.globalAlpha = 1
  const ground = at(run.s[row]!)
  const middle = moved(ground, out, size / 2)
  drawBlock(context, middle, { angle, size, fill })
  // Of the acceleration: the forces themselves differ as much as the masses.
  const { sum, acceleration } = forcesIn(run, row)
  const from = moved(middle, out, size / 2 + 14)
  drawNamedArrows(context, [arrowFor('sum', 'a', from, acceleration, 0.026 * width)], palette)
  context.strokeStyle = palette.accent
  context.setLineDash([4, 4])
  context.lineWidth = 1
  line(context, { x: ground.x, y: 0 }, { x: ground.x, y: height })
  context.setLineDash([])
  const [right, low] = [width - 16, height - 14]
  context.font = `600 14px ${palette.sans}`
  context.fillStyle = text
  write(context, `${mass} kg`, right, low - 40, { align: 'right' })
  context.font = `13px ${palette.sans}`
  context.fillStyle = palette.ink
  write(context, `ΣF = ${fixed(length(sum), 2)}\u202fN`, right, low - 20, { align: 'right' })
  const a = `a = ΣF / m = ${fixed(length(acceleration), 2)}\u202fm/s²`
  write(context, a, right, low, { align: 'right' })
}
