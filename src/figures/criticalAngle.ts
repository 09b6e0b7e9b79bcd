import { length, simulate } from '../physics/index.ts'
import type { Experiment, Trajectory } from '../physics/index.ts'
import { moved } from '../chart/geometry.ts'
import { degrees, fixed } from '../chart/numbers.ts'
import { rowAt } from '../view/timeline.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { drawBlock, drawNamedArrows } from './shared/slope.ts'
import {
  angleControl,
  arrowFor,
  drawTilted,
  forcesOn,
  muControl,
  STEEPEST,
  tiltedSlope,
  tiltGrip,
} from './shared/tilted.ts'

interface TiltValues {
  readonly angle: number
  readonly mu: number
  /** The steepest angle tried at which it held, and the flattest at which it slid [°]. */
  readonly held: number
  readonly slid: number
}

const bracket = (label: string, initial: number) =>
  ({ type: 'number', label, unit: '°', from: 0, to: 90, step: 0.5, initial, hidden: true }) as const

/** The angle at which a block at rest sets off, to be found by hand. */
export const criticalAngle = figure({
  id: 'critical-angle',
  title: 'How steep until it slides?',
  pictured:
    'A block at rest on a slope that can be tilted, with gravity, the normal force and the friction that holds it.',
  controls: {
    angle: { ...angleControl(10), step: 0.1 },
    mu: { ...muControl(0.45), label: 'Static friction', symbol: 'μs' },
    held: bracket('Held at', 10),
    slid: bracket('Slid at', 90),
  },
  experiments,
  follow: (values, before) => {
    const fresh = values.mu === before.mu ? values : { ...values, held: 0, slid: 90 }
    return stays(simulate(experiments(fresh)[0]!))
      ? { ...fresh, held: Math.max(fresh.held, fresh.angle) }
      : { ...fresh, slid: Math.min(fresh.slid, fresh.angle) }
  },
  panels: [
    {
      shape: { wide: 0.52, narrow: 0.86 },
      draw,
      grips: (size, { values }) => [tiltGrip(size, values.angle)],
    },
  ],
  says: ({ angle, mu, held, slid }, [run]) => {
    const now = stays(run!)
      ? `At ${degrees(angle)} it stays: friction takes all of the pull.`
      : `At ${degrees(angle)} it slides: the pull is more than μs N.`
    if (slid > STEEPEST) return `${now} Tilt on, until it sets off.`
    const found = `So the limit is between ${degrees(held)} and ${degrees(slid)}.`
    return slid - held > 2.05
      ? `${now} ${found} Come closer.`
      : `${now} ${found} The formula says atan ${fixed(mu, 2)} = ${fixed(atan(mu), 2)}°.`
  },
  readings: ({ mu, held, slid }, [run]) => {
    const { normal, gravity, along } = forcesIn(run!)
    const pull = Math.abs(gravity.x * along.x + gravity.y * along.y)
    const most = mu * length(normal)
    const known = slid <= STEEPEST
    return [
      {
        label: 'Pull along the slope',
        text: `${fixed(pull, 2)} N`,
        raw: pull,
        colour: '--force-gravity',
      },
      {
        label: 'Most that friction can hold',
        text: `${fixed(most, 2)} N`,
        raw: most,
        colour: '--force-friction',
      },
      {
        label: 'You found',
        text: known ? `${degrees(held)} … ${degrees(slid)}` : `over ${degrees(held)}`,
      },
    ]
  },
})

function experiments({ angle, mu }: Pick<TiltValues, 'angle' | 'mu'>): Experiment[] {
  return [
    {
      scene: 'ramp',
      parameters: { angle, muStatic: mu, muKinetic: Number((0.8 * mu).toFixed(4)) },
      duration: 0.6,
    },
  ]
}

function stays({ outcome }: Trajectory): boolean {
  return outcome.kind === 'at-rest'
}

/** [°] */
function atan(mu: number): number {
  return (Math.atan(mu) * 180) / Math.PI
}

function forcesIn({ experiment, s, v }: Trajectory) {
  return forcesOn(experiment, { s: s[0]!, v: v[0]! })
}

function draw(surface: DrawingSurface, { values, runs, lit }: View<TiltValues>): void {
  const { context, width, height, palette } = surface
  drawTilted(surface, values.angle)
  const { slope, size } = tiltedSlope(surface, values.angle)
  const run = runs[0]!
  const { fill } = palette.runners[stays(run) ? 2 : 0]!
  const metre = 0.5 * width
  context.globalAlpha = 0.14
  for (let t = 0.1; t < 0.61 && !stays(run); t += 0.1) {
    const ground = moved(slope.at, slope.along, metre * run.s[rowAt(run, t)]!)
    drawBlock(context, moved(ground, slope.out, size / 2), { angle: slope.angle, size, fill })
  }
  context.globalAlpha = 1
  const middle = moved(slope.at, slope.out, size / 2)
  drawBlock(context, middle, { angle: slope.angle, size, fill, pale: true })
  const { gravity, normal, friction, along } = forcesIn(run)
  const scale = (0.34 * Math.min(height, 0.8 * width)) / 9.81
  const base = moved(slope.at, slope.out, 3)
  const most = values.mu * length(normal)
  const limit = { x: -most * along.x, y: -most * along.y }
  drawNamedArrows(
    context,
    [
      arrowFor('gravity', 'G', middle, gravity, scale),
      arrowFor('normal', 'N', middle, normal, scale),
      { ...arrowFor('friction', 'μs N', moved(base, slope.out, -30), limit, scale), dashed: true },
      arrowFor('friction', 'F', base, friction, scale),
    ],
    palette,
    lit,
  )
}
