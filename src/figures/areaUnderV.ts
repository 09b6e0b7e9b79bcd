import { exact } from '../physics/index.ts'
import type { Experiment, IntegratorId, Trajectory } from '../physics/index.ts'
import { drawAxes, drawCurve, graphIn, line } from '../chart/graph.ts'
import type { Graph } from '../chart/graph.ts'
import { fixed } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'

/** As far as the axis of time goes [s]. */
const END = 2
const parameters = { angle: 30, muStatic: 0.2, muKinetic: 0.2 } as const

interface AreaValues {
  readonly step: number
  readonly method: 'explicit-euler' | 'semi-implicit-euler' | 'velocity-verlet'
}

/** How far ahead of the area each method is, in halves of a T Δt. */
const ahead = { 'explicit-euler': -1, 'semi-implicit-euler': 1, 'velocity-verlet': 0 } as const

/** The distance as the area under the speed, in bars as wide as a step. */
export const areaUnderV = figure({
  id: 'area-under-v',
  title: 'The area under the speed',
  pictured:
    'The speed over time, a straight line, and under it a bar for every step: the area of the bars is the distance that the method goes, the area under the line the true one.',
  controls: {
    step: {
      type: 'number',
      label: 'Step',
      symbol: 'Δt',
      unit: 's',
      from: 0.05,
      to: 1,
      step: 0.01,
      initial: 0.4,
    },
    method: {
      type: 'choice',
      label: 'Bars',
      options: [
        { id: 'explicit-euler', label: 'from the left: old v' },
        { id: 'semi-implicit-euler', label: 'from the right: new v' },
        { id: 'velocity-verlet', label: 'slanted: both' },
      ],
      initial: 'semi-implicit-euler',
    },
  },
  experiments: ({ step, method }): Experiment[] => {
    const fps = 1 / step
    return [
      {
        scene: 'ramp',
        parameters,
        integrator: method satisfies IntegratorId,
        frames: { kind: 'steady', fps },
        // As many whole steps as there is room for.
        duration: Math.floor(END * fps + 1e-9) / fps,
      },
    ]
  },
  panels: [
    {
      shape: { wide: 0.5, narrow: 0.84 },
      draw,
      grips: (size, { values, runs }) => {
        const { x, y, box } = graphOf(size, runs[0]!)
        return [
          {
            control: 'step',
            x: x(values.step),
            y: y(0),
            at: (point) => ((point.x - box.left) / (box.right - box.left)) * END,
          },
        ]
      },
    },
  ],
  says: ({ step, method }, [run]) => {
    const { time } = gapsOf(run!, method)
    const bars = `${run!.frames} ${run!.frames === 1 ? 'step' : 'steps'} of ${fixed(step, 2)} s make ${fixed(time, 2)} s.`
    const why = {
      'explicit-euler':
        'Each bar is as high as the speed at its left: it leaves out a triangle, ½ a Δt².',
      'semi-implicit-euler':
        'Each bar is as high as the speed at its right: it adds a triangle, ½ a Δt².',
      'velocity-verlet':
        'Each bar is slanted like the line itself: nothing is left out, nothing added.',
    }[method]
    return `${bars} ${why}`
  },
  readings: ({ method }, [run]) => {
    const { truth, predicted, measured } = gapsOf(run!, method)
    return [
      { label: 'True area', text: metresText(truth), raw: truth },
      {
        label: `Predicted${predicted === 0 ? '' : ', ½ a T Δt'}`,
        text: signed(predicted),
        raw: predicted,
      },
      { label: 'Measured gap', text: signed(measured), raw: measured, colour: '--wrong' },
    ]
  },
})

/** The distance that the block really goes, and the gap to it: as the formula has it, and as the run shows it [m]. */
export function gapsOf(run: Trajectory, method: keyof typeof ahead) {
  const time = run.time[run.frames]!
  const { s, v } = exact(run.experiment, time)
  // a T = v, as it starts from rest.
  const predicted = 0.5 * ahead[method] * v * run.time[1]!
  return { time, truth: s, predicted, measured: run.s[run.frames]! - s }
}

function metresText(value: number): string {
  return `${fixed(value, 3)}\u202fm`
}

function signed(value: number): string {
  const text = metresText(value)
  return value > 0 && /[1-9]/.test(text) ? `+${text}` : text
}

function graphOf(
  { width, height }: Pick<DrawingSurface, 'width' | 'height'>,
  run: Trajectory,
): Graph {
  const box = { left: 46, right: width - 24, top: 34, bottom: height - 36 }
  const top = exact(run.experiment, END).v
  return graphIn(box, [0, END], [0, 1.02 * top])
}

function draw(surface: DrawingSurface, { values, runs }: View<AreaValues>): void {
  const { context, width, height, palette } = surface
  const run = runs[0]!
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const graph = graphOf(surface, run)
  const { x, y, box } = graph
  drawAxes(context, graph, { across: 's', up: 'speed, m/s' }, palette)
  const { fill } = palette.runners[1]!
  const { method } = values
  for (let row = 1; row <= run.frames; row++) {
    const [left, right] = [x(run.time[row - 1]!), x(run.time[row]!)]
    const [before, after] = [y(run.v[row - 1]!), y(run.v[row]!)]
    const corners = {
      'explicit-euler': [before, before],
      'semi-implicit-euler': [after, after],
      'velocity-verlet': [before, after],
    }[method] as [number, number]
    const bar = () => {
      context.beginPath()
      context.moveTo(left, y(0))
      context.lineTo(left, corners[0])
      context.lineTo(right, corners[1])
      context.lineTo(right, y(0))
      context.closePath()
    }
    context.fillStyle = fill
    context.globalAlpha = 0.22
    bar()
    context.fill()
    // The triangle that the bar has too much or too little.
    context.fillStyle = palette.wrong
    context.globalAlpha = 0.5
    context.beginPath()
    context.moveTo(left, before)
    context.lineTo(right, after)
    context.lineTo(
      method === 'explicit-euler' ? right : left,
      method === 'explicit-euler' ? before : after,
    )
    if (method !== 'velocity-verlet') context.fill()
    context.globalAlpha = 1
    context.strokeStyle = fill
    context.lineWidth = 1.25
    bar()
    context.stroke()
  }
  const top = exact(run.experiment, END).v
  drawCurve(
    context,
    [
      { x: x(0), y: y(0) },
      { x: x(END), y: y(top) },
    ],
    { colour: palette.ink, width: 2.25 },
  )
  context.font = `600 13px ${palette.sans}`
  context.fillStyle = palette.ink
  write(context, 'v = a t', x(0.7 * END) + 10, y(0.7 * top) + 24, { halo: palette.sheet })
  context.strokeStyle = palette.accent
  context.lineWidth = 1.5
  line(context, { x: x(values.step), y: y(0) }, { x: x(values.step), y: box.bottom + 8 })
  context.fillStyle = palette.accentText
  write(context, `Δt = ${fixed(values.step, 2)} s`, x(values.step) + 14, y(0) - 8, {
    halo: palette.sheet,
  })
}
