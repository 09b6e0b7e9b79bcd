import * as Plot from '@observablehq/plot'
import type { Frontier, WorkCurve } from '../schema/index.ts'
import { inMetres, nanoseconds, plainNumber } from '../text/numbers.ts'
import { draw, metricPower, powers, ink, line, runner, softInk, legend } from './draw.ts'
import type { DiagramDrawing } from './draw.ts'

/** Below this an error is an accident of rounding, and drawn here [m]. */
const FLOOR = 1e-15
/** Above this nobody wants it [m]. */
const CEILING = 10

const symbols: readonly Plot.SymbolType[] = [
  ...(['circle', 'square', 'triangle', 'diamond', 'star', 'cross', 'wye', 'hexagon'] as const),
]

const costs = {
  evaluations: { word: 'evaluations of the acceleration', show: plainNumber },
  time: { word: 'time', show: nanoseconds },
} as const

/** Speed against error: a curve for each method, a point for each step length. */
export function frontierDiagram(frontier: Frontier, cost: 'evaluations' | 'time'): DiagramDrawing {
  const { id, label, about, curves, at } = frontier
  const keys = curves.map((curve, i) => ({
    label: curve.label,
    colour: curve.colour === null ? ink : runner(curve.colour),
    symbol: symbols[i % symbols.length]!,
  }))
  const points = (curve: WorkCurve) =>
    curve.points
      .map((point) => ({ cost: point[cost], error: Math.max(point.error, FLOOR) }))
      .filter(({ error }) => error <= CEILING)
  const all = curves.flatMap(points)
  const span = (key: 'cost' | 'error'): [number, number] => {
    const values = all.map((point) => point[key])
    return [Math.min(...values) / 1.3, Math.max(...values) * 1.3]
  }
  const [cheap, dear] = span('cost')
  const [small, large] = span('error')
  const { word, show } = costs[cost]
  const best = cost === 'time' ? 'quickest' : 'fewest'
  const words = at.map((row) => {
    const own = row[best]
    return `To ${inMetres(row.error)}: ${own ? `${show(own[cost])} with ${own.label}` : 'none of ours'}, ${row.odex ? `${show(row.odex[cost])} with odex` : 'odex does not get there'}.`
  })
  return draw(
    {
      file: `${id}-${cost}.svg`,
      title: `${label}: error against ${word}`,
      description: `${label}, ${about}. Error against ${word} for one simulated second, both logarithmic; down and to the left is better. ${words.join(' ')}`,
    },
    {
      marginRight: 168,
      x: { type: 'log', domain: [cheap, dear], label: null },
      y: { type: 'log', domain: [small, large], label: null },
      marks: [
        Plot.gridX(powers(cheap, dear), { stroke: line, strokeOpacity: 1 }),
        Plot.gridY(powers(small, large, 3), { stroke: line, strokeOpacity: 1 }),
        Plot.axisX(powers(cheap, dear), {
          tickFormat: (value: number) => show(value),
          label: `${word} for one simulated second`,
          labelAnchor: 'center',
          tickSize: 0,
          fill: softInk,
        }),
        Plot.axisY(powers(small, large, 3), {
          tickFormat: metricPower,
          label: 'largest error',
          tickSize: 0,
          fill: softInk,
        }),
        ...curves.flatMap((curve, i) => {
          const { colour, symbol } = keys[i]!
          const data = points(curve)
          return [
            Plot.line(data, { x: 'cost', y: 'error', stroke: colour, strokeWidth: 1.5 }),
            Plot.dot(data, { x: 'cost', y: 'error', fill: colour, symbol, r: 3 }),
          ]
        }),
        ...legend(keys),
      ],
    },
  )
}
