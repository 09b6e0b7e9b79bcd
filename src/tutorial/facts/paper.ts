import { allCorrected, dot, length, paperStep } from '../../physics/index.ts'
import type { PaperBody, Corrections, Surface } from '../../physics/index.ts'
import { fixed, metres, plain, speed } from '../../chart/numbers.ts'
import type { Facts } from './fact.ts'

/** A speed that shows the first step which way friction points, and moves nothing [m/s]. */
const NUDGE = 1e-9

const signed = (value: number) => `${value > 0 ? '+' : ''}${fixed(value, 3)}\u202fm`

/** A slope down to the left, as in the figure. */
function slope(degrees: number, muKinetic: number) {
  const angle = (degrees * Math.PI) / 180
  const surface: Surface = {
    g: { x: 0, y: -9.81 },
    n: { x: -Math.sin(angle), y: Math.cos(angle) },
    mass: 1,
    muKinetic,
    muStatic: muKinetic,
  }
  return { surface, along: { x: -Math.cos(angle), y: -Math.sin(angle) } }
}

interface Slide {
  readonly on: ReturnType<typeof slope>
  /** Downhill [m/s]. */
  readonly speed: number
  readonly fps: number
  readonly frames: number
}

/** The block of the figure after a second. */
const figure: Slide = { on: slope(20, 0.5), speed: 3, fps: 30, frames: 30 }

/** Runs the paper's step with one of its corrections left out, or none; the bodies after each frame. */
function run(
  { on: { surface, along }, speed: v, fps, frames }: Slide,
  without?: keyof Corrections,
) {
  const how = without ? { ...allCorrected, [without]: false } : allCorrected
  let body: PaperBody = { r: { x: 0, y: 0 }, v: { x: v * along.x, y: v * along.y } }
  return Array.from({ length: frames }, () => {
    body = paperStep(body, surface, 1 / fps, how)
    return body
  })
}

/** How far below the surface the block of the figure is after a second [m]. */
const depth = (without: keyof Corrections) =>
  -dot(run(figure, without).at(-1)!.r, figure.on.surface.n)

/** Friction with a direction that is not of length one, as a multiple of Coulomb's, at a speed. */
function frictionAt(v: number): number {
  const flat: Slide = { on: slope(0, 0.5), speed: v, fps: 60, frames: 1 }
  const loss = (without?: keyof Corrections) => v - length(run(flat, without)[0]!.v)
  return loss('unitSlipDirection') / loss()
}

/** How far off ½aT² it is after two seconds on the ramp of 30°, a = g (sin 30° − 0.2 cos 30°) [m]. */
function ahead(without?: keyof Corrections): number {
  const on = slope(30, 0.2)
  const { r } = run({ on, speed: NUDGE, fps: 60, frames: 120 }, without).at(-1)!
  const { g, n, muKinetic } = on.surface
  return dot(r, on.along) - 0.5 * (dot(g, on.along) + muKinetic * dot(g, n)) * 4
}

/** What becomes of a block when a correction is left out. */
export const paper = {
  paperAside: { value: () => depth('normalIsVector'), show: metres },
  paperFriction2: { value: () => frictionAt(2), show: plain },
  paperFriction05: { value: () => frictionAt(0.5), show: plain },
  // As it is after ten seconds: it comes nearer to it by μ g cos 20° = 4.6 e-folds a second.
  paperSteady: {
    value: () => length(run({ ...figure, frames: 300 }, 'unitSlipDirection').at(-1)!.v),
    show: speed,
  },
  paperSunk: { value: () => depth('normalInSum'), show: metres },
  paperTremble: {
    value: () =>
      Math.max(...run({ ...figure, speed: 0 }, 'staticFriction').map(({ v }) => length(v))),
    show: speed,
  },
  paperForward: { value: () => ahead('newVelocity'), show: signed },
  paperSemi: { value: () => ahead(), show: signed },
} as const satisfies Facts
