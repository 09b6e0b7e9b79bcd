import * as Plot from '@observablehq/plot'
import { byHand, ours, recorded } from '../engines/index.ts'
import type { Report } from '../schema/index.ts'
import { inMetres, nanoseconds, asMultiple } from '../text/numbers.ts'
import { draw, metricPower, powers, ink, line, runner, softInk, legend } from './draw.ts'
import type { DiagramDrawing } from './draw.ts'

/** An error of exactly 0 is drawn here [m]. */
const FLOOR = 1e-16

/** Ours stands out; the others keep their colour and shape in both diagrams. */
const looks: Readonly<Record<string, { colour: string; symbol: Plot.SymbolType }>> = {
  [ours[0].id]: { colour: ink, symbol: 'star' },
  [ours[1].id]: { colour: runner(7), symbol: 'hexagon' },
  [recorded.id]: { colour: ink, symbol: 'wye' },
  [byHand.id]: { colour: softInk, symbol: 'cross' },
  'matter-js': { colour: runner(0), symbol: 'circle' },
  planck: { colour: runner(1), symbol: 'square' },
  rapier2d: { colour: runner(2), symbol: 'triangle' },
  'box2d-wasm': { colour: runner(3), symbol: 'diamond' },
}
const otherwise = { colour: runner(4), symbol: 'cross' } as const

type Figures = Pick<Report, 'engines' | 'engineTests'>

/** Who has figures in a list, and how it is drawn. */
function known({ engines }: Figures, figures: readonly { engine: string }[]) {
  return engines
    .filter(({ id }) => figures.some(({ engine }) => engine === id))
    .map(({ id, label }) => ({ id, label, ...(looks[id] ?? otherwise) }))
}

/** What one step costs: the median, and the span from the quickest round to the slowest. */
export function engineTimesDiagram(figures: Figures): DiagramDrawing {
  const shown = known(figures, figures.engineTests.times).map((each) => {
    const found = figures.engineTests.times.find(({ engine }) => engine === each.id)!
    return { ...each, ...found.step, ratio: found.ratio }
  })
  const least = Math.min(...shown.map((each) => each.least)) / 1.5
  const most = Math.max(...shown.map((each) => each.most)) * 1.3
  const words = shown.map(
    ({ label, median, ratio }) => `${label} ${nanoseconds(median)} (${asMultiple(ratio)})`,
  )
  return draw(
    {
      file: 'engines-time.svg',
      title: 'Time of a step with one block on one ramp, a call for each',
      description: `Time of one step with one block sliding down one ramp, a call for each step, logarithmic; to the left is better. ${words.join(', ')}.`,
    },
    {
      height: 260,
      marginLeft: 176,
      marginRight: 80,
      x: { type: 'log', domain: [least, most], label: null },
      y: { domain: shown.map(({ label }) => label), label: null },
      marks: [
        Plot.gridX(powers(least, most), { stroke: line, strokeOpacity: 1 }),
        Plot.axisX(powers(least, most), {
          tickFormat: (value: number) => nanoseconds(value),
          label: 'time of a step',
          labelAnchor: 'center',
          tickSize: 0,
          fill: softInk,
        }),
        Plot.axisY({ tickSize: 0, label: null }),
        Plot.ruleY(shown, {
          y: 'label',
          x1: 'least',
          x2: 'most',
          stroke: 'colour',
          strokeWidth: 2,
        }),
        Plot.dot(shown, { x: 'median', y: 'label', fill: 'colour', symbol: 'symbol', r: 6 }),
        Plot.text(shown, {
          x: 'most',
          y: 'label',
          text: ({ median }: { median: number }) => nanoseconds(median),
          textAnchor: 'start',
          dx: 8,
          fill: 'var(--ink)',
        }),
      ],
    },
  )
}

/** Errors in every scene at 10 fps. */
export function engineErrorsDiagram(figures: Figures): DiagramDrawing {
  const { scenes, runs } = figures.engineTests
  const clock = '10 fps'
  const engines = known(figures, runs)
  const dots = engines.flatMap(({ id, colour, symbol }) =>
    scenes.flatMap((scene) => {
      const run = runs.find(
        (each) => each.engine === id && each.scene === scene.id && each.clock === clock,
      )
      return run && run.error !== null
        ? {
            engine: id,
            scene: scene.label,
            error: Math.max(run.error, FLOOR),
            colour,
            symbol,
          }
        : []
    }),
  )
  const most = Math.max(...dots.map(({ error }) => error)) * 3
  const words = scenes.map(({ id, label }) => {
    const of = (engine: string) =>
      runs.find((run) => run.scene === id && run.clock === clock && run.engine === engine)?.error
    const others = engines
      .filter((each) => !ours.some((own) => own.id === each.id))
      .flatMap((each) => of(each.id) ?? [])
    return `${label}: ${inMetres(of(ours[0].id) ?? null)} against ${inMetres(Math.min(...others))} to ${inMetres(Math.max(...others))} of the engines.`
  })
  return draw(
    {
      file: 'engines-error.svg',
      title: `Error at the end of each scene at ${clock}`,
      description: `How far the block is from where it should be at the end of each scene, at ${clock}, logarithmic; to the left is better. ${words.join(' ')}`,
    },
    {
      height: 340,
      marginLeft: 140,
      marginRight: 140,
      x: { type: 'log', domain: [FLOOR / 3, most], label: null },
      y: { type: 'point', domain: scenes.map(({ label }) => label), label: null },
      marks: [
        Plot.gridX([FLOOR, ...powers(FLOOR, most, 3)], { stroke: line, strokeOpacity: 1 }),
        Plot.axisX([FLOOR, ...powers(FLOOR, most, 3)], {
          tickFormat: (value: number) => (value < 2 * FLOOR ? '0' : metricPower(value)),
          label: 'error',
          labelAnchor: 'center',
          tickSize: 0,
          fill: softInk,
        }),
        Plot.axisY({ tickSize: 0, label: null }),
        // Apart a little, so that engines with the same error are all seen.
        ...engines.map(({ id }, i) =>
          Plot.dot(
            dots.filter(({ engine }) => engine === id),
            {
              ...{ x: 'error', y: 'scene', fill: 'colour', symbol: 'symbol', r: 5 },
              dy: 4 * (i - (engines.length - 1) / 2),
            },
          ),
        ),
        ...legend(engines),
      ],
    },
  )
}
