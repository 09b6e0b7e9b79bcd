import { dot, length } from '../physics/index.ts'
import type { Experiment, ForceVectors, Trajectory } from '../physics/index.ts'
import { moved } from '../chart/geometry.ts'
import { fixed } from '../chart/numbers.ts'
import { figure } from './shared/figure.ts'
import type { FigureReading, DrawingSurface, View } from './shared/figure.ts'
import { drawBlock, drawNamedArrows } from './shared/slope.ts'
import {
  angleControl,
  arrowFor,
  drawTilted,
  forcesOn,
  muControl,
  tiltedSlope,
  tiltGrip,
} from './shared/tilted.ts'

/** As the block moves when it is looked at [m/s]; downhill is plus. */
const speeds = { down: 2, rest: 0, up: -2 } as const

interface SlopeValues {
  readonly angle: number
  readonly mu: number
  readonly mass: number
  readonly moves: keyof typeof speeds
}

/** Gravity, the normal force and friction on a block, to scale. */
export const forcesOnSlope = figure({
  id: 'forces-on-slope',
  title: 'Three forces and their sum',
  pictured:
    'A block on a slope with an arrow for each force on it, to scale: gravity straight down, the normal force out of the slope, friction along it, and their sum.',
  controls: {
    angle: angleControl(30),
    mu: muControl(0.3),
    mass: {
      type: 'number',
      label: 'Mass',
      symbol: 'm',
      unit: 'kg',
      from: 1,
      to: 3,
      step: 0.1,
      initial: 2,
    },
    moves: {
      type: 'choice',
      label: 'The block',
      options: [
        { id: 'down', label: 'slides down' },
        { id: 'rest', label: 'is let go' },
        { id: 'up', label: 'was kicked up' },
      ],
      initial: 'down',
    },
  },
  experiments: ({ angle, mu, mass, moves }): Experiment[] => [
    {
      scene: 'ramp',
      parameters: { angle, mass, muStatic: mu, muKinetic: mu, speed: speeds[moves] },
      duration: 1,
    },
  ],
  panels: [
    {
      shape: { wide: 0.54, narrow: 0.92 },
      draw,
      grips: (size, { values }) => [tiltGrip(size, values.angle)],
    },
  ],
  says: ({ mu }, [run]) => {
    const { frictionKind, sum, normal, friction, along } = forcesIn(run!)
    if (frictionKind === 'held')
      return `It stays: friction is as large as it has to be, ${newtons(length(friction))} of the ${newtons(mu * length(normal))} that it could be, and the sum is 0.`
    const { mass } = run!.experiment.parameters
    const a = length(sum) / mass!
    const how =
      frictionKind === 'none'
        ? 'There is no friction.'
        : `Friction is μ N = ${fixed(mu, 2)} × ${newtons(length(normal))}, against the motion.`
    if (a < 0.005) return `${how} The sum is 0: it keeps its speed.`
    const faster = dot(sum, along) * (run!.v[0]! || 1) >= 0
    return `${how} The sum makes it ${faster ? 'faster' : 'slower'} by ${fixed(a, 2)} m/s every second, along the slope; across it nothing is left.`
  },
  readings: (_, [run]) => {
    const { gravity, normal, friction, sum } = forcesIn(run!)
    return [
      force('Gravity G', length(gravity), '--force-gravity'),
      force('Normal force N', length(normal), '--force-normal'),
      force('Friction F', length(friction), '--force-friction'),
      force('Sum ΣF', length(sum), '--force-sum'),
    ]
  },
})

function force(label: string, value: number, colour: string): FigureReading {
  return { label, text: newtons(value), raw: value, colour }
}

function newtons(value: number): string {
  return `${fixed(value, 2)}\u202fN`
}

/** At the beginning of the run. */
function forcesIn({ experiment, s, v }: Trajectory): ForceVectors {
  return forcesOn(experiment, { s: s[0]!, v: v[0]! })
}

function draw(surface: DrawingSurface, { values, runs, lit }: View<SlopeValues>): void {
  const { context, width, height, palette } = surface
  drawTilted(surface, values.angle)
  const { slope, size } = tiltedSlope(surface, values.angle)
  const { gravity, normal, friction, sum, along } = forcesIn(runs[0]!)
  // The heaviest block's weight just fits into the picture.
  const scale = (0.43 * Math.min(height, 0.9 * width)) / (3 * 9.81)
  const side = size * Math.cbrt(values.mass / 3)
  const middle = moved(slope.at, slope.out, side / 2)
  const { fill } = palette.runners[1]!
  drawBlock(context, middle, { angle: slope.angle, size: side, fill, pale: true })
  const base = moved(slope.at, slope.out, 3)
  const arrows = [
    arrowFor('gravity', 'G', middle, gravity, scale),
    arrowFor('normal', 'N', middle, normal, scale),
    arrowFor('friction', 'F', base, friction, scale),
    arrowFor('sum', 'ΣF', moved(middle, slope.out, 0.22 * side), sum, scale),
  ]
  if (values.moves !== 'rest') {
    const speed = speeds[values.moves]
    const way = { x: along.x * speed, y: along.y * speed }
    const from = moved(middle, slope.out, side / 2 + 16)
    arrows.push(arrowFor('velocity', 'v', from, way, 26))
  }
  drawNamedArrows(context, arrows, palette, lit)
}
