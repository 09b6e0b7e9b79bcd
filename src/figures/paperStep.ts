import { asPrinted, corrections, exactMotion, paperStep as step } from '../physics/index.ts'
import type { PaperBody, Corrections, ExactMotion, Experiment, Vector } from '../physics/index.ts'
import { moved } from '../chart/geometry.ts'
import type { Point } from '../chart/geometry.ts'
import { clipTo, dot } from '../chart/graph.ts'
import { write } from '../chart/text.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'
import { drawBlock, drawSlope, slopeThrough } from './shared/slope.ts'
import { roughly } from './shared/readings.ts'

const DURATION = 3
const parameters = { angle: 20, muStatic: 0.5, muKinetic: 0.5, speed: 3 } as const
const radians = (parameters.angle * Math.PI) / 180
/** Downhill, to the left, and out of the slope; y upwards. */
const along = { x: -Math.cos(radians), y: -Math.sin(radians) }
const normal = { x: -Math.sin(radians), y: Math.cos(radians) }

type PaperValues = Corrections & { readonly fps: number }

const makes = (name: keyof Corrections, label: string) => {
  const { happens, corrected } = corrections.find((each) => each.makes === name)!
  return {
    type: 'switch',
    label,
    initial: asPrinted[name],
    about: { on: corrected, off: happens },
  } as const
}

/** The printed step with each of its corrections as a switch. */
export const paperStep = figure({
  id: 'paper-step',
  title: 'The step as printed, corrected line by line',
  pictured:
    'A block that slides down a slope: a dot for every frame of the paper’s step in the plane, and the outline of the exact block, which stops.',
  controls: {
    fps: rateControl(30),
    normalIsVector: makes('normalIsVector', 'N is a vector'),
    unitSlipDirection: makes('unitSlipDirection', 'v̂ has length one'),
    normalInSum: makes('normalInSum', 'N is in the sum'),
    staticFriction: makes('staticFriction', 'Static friction'),
    newVelocity: {
      ...makes('newVelocity', 'r moves with the new v'),
      about: {
        on: 'So its formula does: it is semi-implicit Euler, whatever the text calls it.',
        off: 'Forward Euler, as the text says. It errs to the other side.',
      },
    },
  },
  experiments: ({ fps }): Experiment[] => [
    { scene: 'ramp', parameters, frames: { kind: 'steady', fps }, duration: DURATION },
  ],
  duration: () => DURATION,
  panels: [{ shape: { wide: 0.46, narrow: 0.8 }, draw }],
  says: (values, [run]) => {
    const path = paperPath(values)
    const { r, v } = path[path.length - 1]!
    const truth = exactMotion(run!.experiment)(DURATION, { s: 0, v: 0 }).s
    const off = Math.hypot(r.x - truth * along.x, r.y - truth * along.y)
    const speed = Math.hypot(v.x, v.y)
    const wrong = Object.entries(values).filter(([, value]) => value === false).length
    const so = `After ${DURATION} s it is ${roughly(off)} from the exact block`
    if (wrong === 0)
      return `${so}: what is left is the step itself. At ${values.fps} fps v = 0 falls between two frames, and the sign of v has no answer to that; stopping has.`
    return speed > 0.05 ? `${so}, and still moves.` : `${so}.`
  },
})

/** The block after each frame, moved by the paper's step in the plane. */
export function paperPath({ fps, ...corrected }: PaperValues): PaperBody[] {
  const surface = {
    ...{ g: { x: 0, y: -9.81 }, n: normal, mass: 1 },
    ...{ muKinetic: parameters.muKinetic, muStatic: parameters.muStatic },
  }
  const { speed } = parameters
  const path: PaperBody[] = [{ r: { x: 0, y: 0 }, v: { x: speed * along.x, y: speed * along.y } }]
  for (let frame = 0; frame < DURATION * fps; frame++)
    path.push(step(path[frame]!, surface, 1 / fps, corrected))
  return path
}

function draw(surface: DrawingSurface, { values, runs, time }: View<PaperValues>): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const size = Math.min(40, 18 + 0.03 * width)
  const scale = (0.62 * width) / 4.4
  const start = { x: 0.84 * width, y: 0.3 * height }
  const onCanvas = ({ x, y }: Vector): Point => ({ x: start.x + scale * x, y: start.y - scale * y })
  const slope = slopeThrough(start, parameters.angle)
  drawSlope(context, slope, surface, palette)
  const path = paperPath(values)
  const now = Math.min(path.length - 1, Math.floor(time * values.fps + 1e-9))
  const { fill, text } = palette.runners[0]!
  const middleOf = (ground: Point) => moved(ground, slope.out, size / 2)
  context.save()
  clipTo(context, { left: 0, right: width, top: 0, bottom: height })
  context.fillStyle = fill
  path.forEach(({ r }, frame) => {
    context.globalAlpha = frame <= now ? 1 : 0.25
    dot(context, onCanvas(r), 2.6)
  })
  context.globalAlpha = 1
  const block = onCanvas(path[now]!.r)
  drawBlock(context, middleOf(block), { angle: slope.angle, size, fill })
  context.restore()
  const exact = middleOf(onCanvas(exactAt(exactMotion(runs[0]!.experiment), time)))
  context.save()
  context.translate(exact.x, exact.y)
  context.rotate(-slope.angle)
  context.strokeStyle = palette.ink
  context.lineWidth = 2
  context.beginPath()
  context.roundRect(-size / 2, -size / 2, size, size, 4)
  context.stroke()
  context.restore()
  context.font = `500 13px ${palette.sans}`
  context.fillStyle = palette.ink
  write(context, 'exact', exact.x, exact.y - size - 4, { align: 'center', halo: palette.sheet })
  context.fillStyle = text
  const isSeen = block.x > 0 && block.x < width && block.y > 0 && block.y < height
  const words = isSeen ? 'the paper’s step' : 'the paper’s step has left the picture'
  write(context, words, 16, 26, { halo: palette.sheet })
}

/** A point of the plane on the exact block's way. */
function exactAt(exact: ExactMotion, time: number): Vector {
  const { s } = exact(time, { s: 0, v: 0 })
  return { x: s * along.x, y: s * along.y }
}
