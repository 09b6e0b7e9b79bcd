import type { Experiment } from '../../src/physics/index.ts'

/**
 * Motions computed by means that share nothing with `src`: the library's trigonometry, straights in closed form, bends by
 * Runge and Kutta's method in steps of a two-hundredth of the bend's own time, events by bisection, and the time to a
 * pipe's lip by quadrature.
 */

interface Block {
  s: number
  v: number
}

/** Steps on bends are so much of √(R/g) and of R/v: (1/200)⁴/120 is 5e-12, and friction's terms are as small. */
const FINENESS = 1 / 200

/** A bend's events are found to rounding: 2⁻⁶⁰ of a step. */
const BISECTIONS = 60

/** The true state of a block on a run-out at the experiment's end, to about 1e-9 m; v is 0 where it rests. */
export function fineRunOut({ parameters, duration }: Experiment): Block {
  const { angle, length, bendRadius, muStatic, muKinetic, gravity, position, speed } = {
    ...{ gravity: 9.81, position: 0, speed: 0 },
    ...parameters,
  } as Record<string, number>
  const slope = (angle! * Math.PI) / 180
  const foot = length! + bendRadius! * slope
  const slopeAt = (s: number) =>
    s <= length! ? slope : s >= foot ? 0 : slope - (s - length!) / bendRadius!
  const accelerate = (s: number, v: number, slip: number, bent: number) =>
    gravity! * Math.sin(slopeAt(s)) -
    slip * muKinetic! * (gravity! * Math.cos(slopeAt(s)) + (bent * v * v) / bendRadius!)
  const block = { s: position!, v: speed! }
  let left = duration!
  while (left > 0) {
    const drive = gravity! * Math.sin(slopeAt(block.s))
    if (block.v === 0 && drive <= muStatic! * gravity! * Math.cos(slopeAt(block.s))) break
    const slip = block.v === 0 ? 1 : Math.sign(block.v)
    const { s } = block
    const onSlope = slip > 0 ? s < length! : s <= length!
    const onFlat = slip > 0 ? s >= foot : s > foot
    if (onSlope) left -= straight(block, accelerate(s, 0, slip, 0), slip, left, -Infinity, length!)
    else if (onFlat) left -= straight(block, accelerate(s, 0, slip, 0), slip, left, foot, Infinity)
    else {
      const dt =
        FINENESS * Math.min(Math.sqrt(bendRadius! / gravity!), bendRadius! / Math.abs(block.v))
      left -= bent(
        block,
        (s, v) => accelerate(s, v, slip, 1),
        slip,
        Math.min(dt, left),
        length!,
        foot,
      )
    }
  }
  return block
}

/** Moves on under a constant acceleration, up to a stop, a joint or that time. Returns the time it took. */
function straight(
  block: Block,
  a: number,
  slip: number,
  most: number,
  from: number,
  to: number,
): number {
  const { s, v } = block
  const turn = a * slip < 0 ? -v / a : Infinity
  const joint = slip > 0 ? to : from
  // 2d/(v + √(v² + 2ad)) is the smaller root, without cancellation; NaN where the joint is out of reach.
  const way = joint - s
  const root = Math.sqrt(v * v + 2 * a * way)
  const reach = Number.isFinite(way) && root >= 0 ? (2 * way) / (v + slip * root) : Infinity
  const time = Math.min(most, turn, reach)
  block.s = time === reach ? joint : s + v * time + 0.5 * a * time * time
  block.v = time === reach ? slip * root : time === turn ? 0 : v + a * time
  return time
}

/** A step of the classical method, shortened to the first event in it. Returns its length. */
function bent(
  block: Block,
  a: (s: number, v: number) => number,
  slip: number,
  dt: number,
  from: number,
  to: number,
): number {
  const { s, v } = block
  const step = (h: number) => {
    const a1 = a(s, v)
    const [s2, v2] = [s + 0.5 * h * v, v + 0.5 * h * a1]
    const a2 = a(s2, v2)
    const [s3, v3] = [s + 0.5 * h * v2, v + 0.5 * h * a2]
    const a3 = a(s3, v3)
    const [s4, v4] = [s + h * v3, v + h * a3]
    block.s = s + (h / 6) * (v + 2 * v2 + 2 * v3 + v4)
    block.v = v + (h / 6) * (a1 + 2 * a2 + 2 * a3 + a(s4, v4))
    return block.v * slip >= 0 && block.s >= from && block.s <= to
  }
  if (step(dt)) return dt
  let early = 0
  let late = dt
  for (let i = 0; i < BISECTIONS; i++) {
    const middle = 0.5 * (early + late)
    if (step(middle)) early = middle
    else late = middle
  }
  step(late)
  if (block.v * slip < 0) block.v = 0
  else block.s = block.s < from ? from : to
  return late
}

/** Gauss's rule of three points on a panel from −1 to 1: exact for polynomials of the fifth degree. */
const GAUSS = [
  { at: -Math.sqrt(0.6), weight: 5 / 9 },
  { at: 0, weight: 8 / 9 },
  { at: Math.sqrt(0.6), weight: 5 / 9 },
]

/**
 * When a block in a pipe without friction, moving at first and with that much more energy than the lip needs, reaches the
 * lip [s].
 */
export function lipTime({ parameters }: Experiment, excess: number): number {
  const { radius, gravity = 9.81, position, speed } = parameters as Record<string, number>
  const slope = (Math.sign(speed!) * position!) / radius!
  const quarter = timeOfLast(Math.PI / 2, excess)
  const rest = timeOfLast(Math.PI / 2 - Math.abs(slope), excess)
  // Down to the bottom it takes as long as up to the same height.
  return (slope >= 0 ? rest : 2 * quarter - rest) * Math.sqrt(radius! / gravity)
}

/**
 * The time for the last bit of the way to the lip, in units of √(R/g): ∫ dθ/√(2 (excess + cos θ)) with θ = π/2 − u² and
 * u = √excess sinh x, which takes the root out of the integrand.
 */
function timeOfLast(way: number, excess: number): number {
  const panels = 500
  const half = Math.asinh(Math.sqrt(way / excess)) / (2 * panels)
  let sum = 0
  for (let panel = 0; panel < panels; panel++)
    for (const { at, weight } of GAUSS) {
      const x = half * (2 * panel + 1 + at)
      const u = Math.sqrt(excess) * Math.sinh(x)
      const slope = Math.sqrt(excess) * Math.cosh(x)
      sum += (weight * 2 * u * slope) / Math.sqrt(2 * (excess + Math.sin(u * u)))
    }
  return sum * half
}
