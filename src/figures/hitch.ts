import { exact, exactMotion } from '../physics/index.ts'
import type { Experiment, Timestep, Trajectory } from '../physics/index.ts'
import { clipTo, dot, drawCurve, graphIn, line } from '../chart/graph.ts'
import { fixed, seconds } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { kick, policies } from './shared/kick.ts'
import type { PolicyId } from './shared/kick.ts'
import { roughly } from './shared/readings.ts'

const DURATION = 1.4
const FPS = 60
/** When the long frame begins, in frames. */
const BEFORE = 18

const timesteps: Readonly<Record<PolicyId, Timestep>> = {
  variable: { kind: 'variable' },
  capped: { kind: 'capped', cap: 0.05 },
  substeps: { kind: 'substeps', step: 1 / FPS },
  fixed: { kind: 'fixed', step: 1 / FPS, maxSteps: 60 },
}

const about: Readonly<Record<PolicyId, string>> = {
  variable: 'takes the whole hitch as one giant step',
  capped: 'takes a short step and drops the rest: the game stands still for that long',
  substeps: 'cuts it into short steps: nothing is lost, and nothing is wrong that was not before',
  fixed: 'makes up for it with as many steps as are due, each as long as always',
}

interface HitchValues {
  readonly length: number
  readonly timestep: PolicyId
}

/** One long frame through every policy at once. */
export const hitch = figure({
  id: 'hitch',
  title: 'One long frame',
  pictured:
    'The kicked block’s way over time, four times over, each with a different policy for a hitch that is shaded.',
  controls: {
    length: {
      type: 'number',
      label: 'The hitch lasts',
      unit: 's',
      from: 0.05,
      to: 0.8,
      step: 0.05,
      initial: 0.25,
    },
    timestep: { type: 'choice', label: 'Look at', options: policies, initial: 'variable' },
  },
  experiments: ({ length }): Experiment[] =>
    policies.map(({ id }) => ({
      ...kick,
      timestep: timesteps[id],
      frames: { kind: 'recorded', durations: framesWith(length) },
      duration: DURATION,
    })),
  panels: [{ shape: { wide: 0.6, narrow: 1.15 }, draw }],
  says: ({ length, timestep }, runs) => {
    const run = runs[policies.findIndex(({ id }) => id === timestep)]!
    const lost = run.lostTime > 0 ? ` ${seconds(run.lostTime)} are lost.` : ''
    return `Of a frame of ${seconds(length)}, “${timestep}” ${about[timestep]}. The block ends at ${fixed(-run.s[run.frames]!, 2)} m, ${roughly(errorOf(run))} from the exact one.${lost}`
  },
})

/** Steady frames with a long one among them [s]. */
function framesWith(length: number): number[] {
  const steady = (count: number) => Array.from({ length: count }, () => 1 / FPS)
  return [...steady(BEFORE), length, ...steady(FPS * DURATION)]
}

/** Of its last row [m]. */
function errorOf({ experiment, s, frames }: Trajectory): number {
  return Math.abs(s[frames]! - exact(experiment, DURATION).s)
}

function draw(surface: DrawingSurface, { values, runs }: View<HitchValues>): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const columns = width < 480 ? 1 : 2
  const wide = (width - 16) / columns
  const high = (height - 8) / Math.ceil(policies.length / columns)
  policies.forEach(({ id, label }, i) => {
    const left = 8 + wide * (i % columns)
    const top = 4 + high * Math.floor(i / columns)
    const box = { left: left + 14, right: left + wide - 14, top: top + 34, bottom: top + high - 16 }
    const chosen = id === values.timestep
    const run = runs[i]!
    const { fill, text } = palette.runners[i]!
    const graph = graphIn(box, [0, DURATION], [-0.1, 2])
    const { x, y } = graph
    const begins = BEFORE / FPS
    context.fillStyle = palette.wrong
    context.globalAlpha = 0.12
    context.fillRect(
      x(begins),
      box.top,
      x(begins + values.length) - x(begins),
      box.bottom - box.top,
    )
    context.globalAlpha = 1
    context.strokeStyle = palette.edge
    context.lineWidth = 1
    line(context, { x: box.left, y: y(0) }, { x: box.right, y: y(0) })
    const exact = exactMotion(run.experiment)
    const truth = Array.from({ length: 71 }, (_, k) => {
      const t = (DURATION * k) / 70
      return { x: x(t), y: y(-exact(t, { s: 0, v: 0 }).s) }
    })
    drawCurve(context, truth, { colour: palette.ink, width: 1.25, dash: [5, 4] })
    context.save()
    clipTo(context, { ...box, right: box.right + 4 })
    context.fillStyle = fill
    run.time.forEach((t, row) =>
      dot(context, { x: x(t), y: y(-run.drawnS[row]!) }, chosen ? 3 : 2.2),
    )
    context.restore()
    context.font = `600 13px ${palette.sans}`
    context.fillStyle = text
    write(context, label, box.left, top + 22)
    context.font = `${chosen ? 600 : 400} 12px ${palette.sans}`
    context.fillStyle = palette.ink
    const lost = run.lostTime > 0 ? `, ${seconds(run.lostTime)} lost` : ''
    const off = `${roughly(errorOf(run))} off${lost}`
    write(context, off, box.right, top + 22, { align: 'right' })
    if (!chosen) return
    context.strokeStyle = fill
    context.lineWidth = 1.75
    context.beginPath()
    context.roundRect(left + 3, top + 3, wide - 6, high - 6, 8)
    context.stroke()
  })
}
