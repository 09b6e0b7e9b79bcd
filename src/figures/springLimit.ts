import { exactMotion, integrators } from '../physics/index.ts'
import type { Experiment, IntegratorId, Trajectory } from '../physics/index.ts'
import { clipTo, dot, drawAxes, drawCurve, graphIn } from '../chart/graph.ts'
import type { Graph } from '../chart/graph.ts'
import { count, fixed, metres } from '../chart/numbers.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'

const FPS = 20
const STEPS = 60
/** The pictures show so many times the true swing, which is of 1 m. */
const REACH = 1.8
interface LimitValues {
  readonly omegaDt: number
  readonly integrator: IntegratorId
}

/** A stiffer and stiffer spring at one frame rate. */
export const springLimit = figure({
  id: 'spring-limit',
  title: 'How stiff is too stiff?',
  pictured:
    'Left, the speed of a block on a spring over its position, a dot for every step, around the true circle; right, its position over time.',
  controls: {
    omegaDt: {
      type: 'number',
      label: 'Stiffness',
      symbol: 'ωΔt',
      from: 0.1,
      to: 3,
      step: 0.01,
      initial: 1.5,
    },
    integrator: {
      type: 'choice',
      label: 'Method',
      options: [
        { id: 'explicit-euler', label: 'explicit Euler' },
        { id: 'semi-implicit-euler', label: 'semi-implicit' },
        { id: 'velocity-verlet', label: 'Verlet' },
        { id: 'rk4', label: 'RK4' },
        { id: 'implicit-midpoint', label: 'implicit midpoint' },
      ],
      initial: 'velocity-verlet',
    },
  },
  experiments: ({ omegaDt, integrator }): Experiment[] => [
    {
      scene: 'spring',
      // On the level, without friction, from 1 m: the true block swings between −1 and 1 m for ever.
      parameters: {
        ...{ angle: 0, muStatic: 0, muKinetic: 0, position: 1 },
        stiffness: (omegaDt * FPS) ** 2,
      },
      integrator,
      frames: { kind: 'steady', fps: FPS },
      duration: STEPS / FPS,
    },
  ],
  panels: [{ shape: { wide: 0.46, narrow: 1.5 }, draw }],
  says: ({ omegaDt, integrator }, [run]) => {
    const { label, stability } = integrators.find(({ id }) => id === integrator)!
    const far = farthest(run!)
    const limit =
      stability === 0
        ? `${label} has no limit to keep to: it always grows`
        : stability === Infinity
          ? `${label} has no limit`
          : omegaDt === stability
            ? `${label} is at its very limit`
            : `${label} is good for ωΔt below ${fixed(stability, 2)}`
    // At the limit itself one method grows, and another stays at what is written as 1 m.
    const bounded = omegaDt < stability || far < 1.005
    return `${limit}; this is ${fixed(omegaDt, 2)}. In ${count(run!.frames)} steps a swing of 1 m ${bounded ? 'got no further than' : 'has grown to'} ${metres(far)}.`
  },
})

/** The farthest that a run gets from the middle [m]. */
function farthest({ s }: Trajectory): number {
  return s.reduce((far, each) => Math.max(far, Math.abs(each)), 0)
}

function draw(surface: DrawingSurface, { values, runs }: View<LimitValues>): void {
  const { context, width, height, palette } = surface
  const run = runs[0]!
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const narrow = height > width
  const side = narrow ? width - 90 : height - 74
  const square = { left: 52, right: 52 + side, top: 36, bottom: 36 + side }
  const portrait = graphIn(square, [-REACH, REACH], [-REACH, REACH])
  drawAxes(context, portrait, { across: 'm', up: 'v / ω, m' }, palette)
  context.strokeStyle = palette.ink
  context.lineWidth = 1.5
  context.beginPath()
  context.arc(portrait.x(0), portrait.y(0), portrait.x(1) - portrait.x(0), 0, 2 * Math.PI)
  context.stroke()
  const omega = values.omegaDt * FPS
  const { fill } = palette.runners[2]!
  const orbit = Array.from(run.s, (s, row) => ({
    x: portrait.x(s),
    y: portrait.y(run.v[row]! / omega),
  }))
  drawDots(surface, portrait, orbit, fill)

  const top = narrow ? square.bottom + 64 : 36
  const box = { left: narrow ? 52 : square.right + 60, right: width - 22, top, bottom: height - 38 }
  const graph = graphIn(box, [0, STEPS / FPS], [-REACH, REACH])
  drawAxes(context, graph, { across: 's', up: 'position, m' }, palette)
  const exact = exactMotion(run.experiment)
  const truth = Array.from({ length: 601 }, (_, i) => {
    const t = (i / 600) * (STEPS / FPS)
    return { x: graph.x(t), y: graph.y(exact(t, { s: 0, v: 0 }).s) }
  })
  context.globalAlpha = 0.45
  drawCurve(context, truth, { colour: palette.ink, width: 1 })
  context.globalAlpha = 1
  drawDots(
    surface,
    graph,
    Array.from(run.s, (s, row) => ({ x: graph.x(run.time[row]!), y: graph.y(s) })),
    fill,
  )
}

/** Dots along a thin line, as far as the box goes. */
function drawDots(
  { context }: DrawingSurface,
  { box }: Graph,
  points: readonly { x: number; y: number }[],
  fill: string,
): void {
  context.save()
  clipTo(context, box)
  context.globalAlpha = 0.4
  drawCurve(context, points, { colour: fill, width: 1 })
  context.globalAlpha = 1
  context.fillStyle = fill
  for (const point of points) dot(context, point, 3)
  context.restore()
}
