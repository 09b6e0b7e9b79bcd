import { integrators } from '../physics/index.ts'
import type { Experiment, IntegratorId, Trajectory } from '../physics/index.ts'
import { mechanicalEnergy } from '../measure/index.ts'
import { clipTo, drawAxes, drawCurve, graphIn, line } from '../chart/graph.ts'
import { plain, seconds } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { rowAt } from '../view/timeline.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { drawRuns } from './shared/scenePanel.ts'

const DURATION = 10
const parameters = { position: 2.2, radius: 2 } as const
const shown = ['explicit-euler', 'semi-implicit-euler', 'velocity-verlet', 'rk4'] as const
const names = {
  'explicit-euler': 'explicit Euler',
  'semi-implicit-euler': 'semi-implicit Euler',
  'velocity-verlet': 'Verlet',
  rk4: 'RK4',
} as const

interface EnergyValues {
  readonly integrator: (typeof shown)[number]
  readonly fps: number
}

/** What there is at the lip, more than which no block keeps to the pipe [J]. */
const LIP = 9.81 * parameters.radius

const kept = new WeakMap<Trajectory, Float64Array>()

/** Worked out once a run, however often it is drawn [J]. */
function energiesOf(run: Trajectory): Float64Array {
  let energies = kept.get(run)
  if (!energies) kept.set(run, (energies = mechanicalEnergy(run)))
  return energies
}

/** The energy in a half-pipe without friction, by method. */
export const halfPipeEnergy = figure({
  id: 'half-pipe-energy',
  title: 'Who gains energy, who keeps it?',
  pictured:
    'A block swings in a half-pipe without friction; below, its energy over time for four methods, and the energy at which it flies out.',
  controls: {
    fps: rateControl(20, 8, 60),
    integrator: {
      type: 'choice',
      label: 'Method',
      options: shown.map((id) => ({ id, label: names[id] })),
      initial: 'explicit-euler',
    },
  },
  experiments: ({ fps }): Experiment[] =>
    shown.map((integrator) => ({
      scene: 'half-pipe',
      parameters,
      integrator: integrator satisfies IntegratorId,
      frames: { kind: 'steady', fps },
      duration: DURATION,
    })),
  duration: () => DURATION,
  panels: [
    {
      shape: { wide: 0.36, narrow: 0.62 },
      draw: (surface, { values, runs, time }) => {
        const { integrator } = values as EnergyValues
        drawRuns(surface, [runs[shown.indexOf(integrator)]!], [names[integrator]], time)
      },
    },
    { shape: { wide: 0.34, narrow: 0.62 }, draw: drawEnergy },
  ],
  says: ({ integrator, fps }, runs) => {
    const run = runs[shown.indexOf(integrator)]!
    const { outcome } = run
    const { label: name, symplectic } = integrators.find(({ id }) => id === integrator)!
    const energies = energiesOf(run)
    const before = energies[0]!
    if (outcome.kind === 'left-the-track')
      return `${name} at ${fps} fps gives the block energy out of nothing at every step: after ${seconds(outcome.time)} it is thrown out of the pipe.`
    if (symplectic)
      return `${name} at ${fps} fps: the energy strays by ${percent(Math.min(...energies) / before - 1)} to ${percent(Math.max(...energies) / before - 1)}, swing after swing.`
    const change = (time: number) => percent(energies[rowAt(run, time)]! / before - 1)
    return `${name} at ${fps} fps: the energy is off by ${change(1)} after one second, and by ${change(DURATION)} after ${DURATION}.`
  },
})

/** “+84 %”, “−1.3 × 10⁻⁶ %”. */
function percent(part: number): string {
  return `${part > 0 ? '+' : ''}${plain(Number((100 * part).toPrecision(2)))}\u202f%`
}

function drawEnergy(surface: DrawingSurface, { values, runs, time }: View<EnergyValues>): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const box = { left: 46, right: width - 22, top: 30, bottom: height - 28 }
  const graph = graphIn(box, [0, DURATION], [0, 24])
  const { x, y } = graph
  drawAxes(context, graph, { across: 's', up: 'energy, J' }, palette)
  context.strokeStyle = palette.wrong
  context.lineWidth = 1.25
  context.setLineDash([6, 4])
  line(context, { x: box.left, y: y(LIP) }, { x: box.right, y: y(LIP) })
  context.setLineDash([])
  context.save()
  clipTo(context, box)
  shown.forEach((integrator, i) => {
    const run = runs[i]!
    const strong = integrator === values.integrator
    context.globalAlpha = strong ? 1 : 0.45
    const energies = energiesOf(run)
    const points = Array.from(energies, (energy, row) => ({ x: x(run.time[row]!), y: y(energy) }))
    drawCurve(context, points, { colour: palette.runners[i]!.fill, width: strong ? 2.75 : 1.5 })
  })
  context.globalAlpha = 1
  context.restore()
  context.font = `500 12px ${palette.sans}`
  context.fillStyle = palette.wrong
  write(context, 'with more than this it leaves the pipe', box.right - 4, y(LIP) - 6, {
    align: 'right',
    halo: palette.sheet,
  })
  drawNames(surface, runs, values.integrator, box.bottom)
  context.strokeStyle = palette.accent
  context.lineWidth = 1
  line(context, { x: x(time), y: box.top }, { x: x(time), y: box.bottom })
}

/** A legend in the lower left, where no curve goes. */
function drawNames(
  { context, palette }: DrawingSurface,
  runs: readonly Trajectory[],
  chosen: string,
  bottom: number,
): void {
  shown.forEach((integrator, i) => {
    const at = { x: 60, y: bottom - 10 - 16 * (shown.length - 1 - i) }
    context.strokeStyle = palette.runners[i]!.fill
    context.lineWidth = integrator === chosen ? 3 : 1.75
    line(context, at, { x: at.x + 20, y: at.y })
    context.font = `${integrator === chosen ? 600 : 400} 12px ${palette.sans}`
    context.fillStyle = palette.ink
    const run = runs[i]!
    const end =
      run.outcome.kind === 'left-the-track' ? `, out after ${seconds(run.outcome.time)}` : ''
    write(context, names[integrator] + end, at.x + 28, at.y + 4, { halo: palette.sheet })
  })
}
