import { dot as product, length } from '../physics/index.ts'
import type { Experiment, Trajectory, Vector } from '../physics/index.ts'
import { moved } from '../chart/geometry.ts'
import { fixed } from '../chart/numbers.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
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

interface PartsValues {
  readonly angle: number
  readonly mu: number
  readonly shown: 'forces' | 'parts' | 'rest'
}

/** Gravity in two parts, of which the normal force takes one. */
export const twoBecomeOne = figure({
  id: 'two-become-one',
  title: 'Two dimensions become one',
  pictured:
    'A block on a slope: gravity is split into a part along the slope and a part across it, which the normal force cancels.',
  controls: {
    angle: angleControl(25),
    mu: muControl(0.2),
    shown: {
      type: 'choice',
      label: 'Show',
      options: [
        { id: 'forces', label: 'G, N and F' },
        { id: 'parts', label: 'G in two parts' },
        { id: 'rest', label: 'what is left' },
      ],
      initial: 'parts',
    },
  },
  experiments: ({ angle, mu }): Experiment[] => [
    { scene: 'ramp', parameters: { angle, muStatic: mu, muKinetic: mu, speed: 1 }, duration: 1 },
  ],
  panels: [
    {
      shape: { wide: 0.52, narrow: 0.86 },
      draw,
      grips: (size, { values }) => [tiltGrip(size, values.angle)],
    },
  ],
  says: (_, [run]) => {
    const { gravity, normal, friction, sum, along, across } = forcesIn(run!)
    const newtons = (value: number) => `${fixed(Math.abs(value), 2)}\u202fN`
    return `Across the slope: ${newtons(product(gravity, across))} of gravity against ${newtons(length(normal))} of N, which leaves nothing. Along it: ${newtons(product(gravity, along))} of pull and ${newtons(length(friction))} of friction, which leaves ${fixed(product(sum, along), 2)}\u202fN. One number is enough.`
  },
})

function forcesIn({ experiment, s, v }: Trajectory) {
  return forcesOn(experiment, { s: s[0]!, v: v[0]! })
}

function draw(surface: DrawingSurface, { values, runs, lit }: View<PartsValues>): void {
  const { context, width, height, palette } = surface
  drawTilted(surface, values.angle)
  const { slope, size } = tiltedSlope(surface, values.angle)
  const middle = moved(slope.at, slope.out, size / 2)
  drawBlock(context, middle, {
    angle: slope.angle,
    size,
    fill: palette.runners[1]!.fill,
    pale: true,
  })
  const { gravity, normal, friction, sum, along, across } = forcesIn(runs[0]!)
  const scale = (0.36 * Math.min(height, 0.8 * width)) / 9.81
  const part = (unit: Vector) => {
    const share = product(gravity, unit)
    return { x: share * unit.x, y: share * unit.y }
  }
  const base = moved(slope.at, slope.out, 3)
  const drive = arrowFor('gravity', 'G along', middle, part(along), scale)
  const rub = arrowFor('friction', 'F', base, friction, scale)
  const { shown } = values
  if (shown === 'rest')
    return drawNamedArrows(
      context,
      [drive, rub, arrowFor('sum', 'ΣF', moved(middle, slope.out, 0.3 * size), sum, scale)],
      palette,
      lit,
    )
  const whole = arrowFor('gravity', 'G', middle, gravity, scale)
  const parts =
    shown === 'parts'
      ? [
          { ...drive, dashed: true as const },
          {
            ...arrowFor('gravity', 'G across', middle, part(across), scale),
            dashed: true as const,
          },
        ]
      : []
  drawNamedArrows(
    context,
    [...parts, whole, arrowFor('normal', 'N', middle, normal, scale), rub],
    palette,
    lit,
  )
}
