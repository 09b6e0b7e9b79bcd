/** A slide over a plane in space for the take-home step, with y upwards, and what a fine integration makes of it. */
export interface Case3d {
  readonly name: string
  readonly gravity: Triple
  readonly normal: Triple
  readonly velocity: Triple
  readonly muStatic: number
  readonly muKinetic: number
  /** How long each frame lasts [s]. */
  readonly frames: readonly number[]
  /** Position and velocity after each frame. */
  readonly rows: readonly Row3d[]
}

export type Triple = readonly [number, number, number]
export type Row3d = readonly [number, number, number, number, number, number]

const SPEED = 5
/** Of the fine integration [s]. */
const FINE = 2e-4

const slopes = [
  { what: 'holds', angle: 15, muStatic: 0.5, muKinetic: 0.5 },
  { what: 'just holds', angle: 40, muStatic: 0.9, muKinetic: 0.9 },
  { what: 'does not hold', angle: 35, muStatic: 0.3, muKinetic: 0.2 },
  { what: 'is flat', angle: 0, muStatic: 0.3, muKinetic: 0.3 },
  { what: 'has no friction', angle: 20, muStatic: 0, muKinetic: 0 },
]

/** The way of the kick, from straight down the slope to almost straight up [°]. */
const ways = [0, 60, 90, 135, 178]

const clocks: readonly (readonly [string, readonly number[]])[] = [
  ...[4, 10, 30, 144].map((fps) => [`${fps} fps`, times(2 * fps, 1 / fps)] as const),
  ['hitches', [...times(20, 1 / 60), 0.4, ...times(20, 1 / 60), 0.5, ...times(25, 1 / 60)]],
]

function times(count: number, length: number): number[] {
  return Array.from({ length: count }, () => length)
}

const sum = (...parts: readonly (readonly [number, Triple])[]): Triple => {
  const along = (i: 0 | 1 | 2) =>
    parts.reduce((total, [factor, each]) => total + factor * each[i], 0)
  return [along(0), along(1), along(2)]
}
const product = (a: Triple, b: Triple) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

/** Every slope, kicked every way, under every clock. */
export const cases3d: readonly Case3d[] = slopes.flatMap(({ what, angle, ...rest }) =>
  ways.flatMap((way) => {
    const radians = (degrees: number) => (degrees * Math.PI) / 180
    const [sin, cos] = [Math.sin(radians(angle)), Math.cos(radians(angle))]
    const [down, across] = [SPEED * Math.cos(radians(way)), SPEED * Math.sin(radians(way))]
    // The slope falls along a direction between x and z.
    const [east, south] = [Math.cos(0.7), Math.sin(0.7)]
    const normal: Triple = [sin * east, cos, sin * south]
    const velocity: Triple = [
      down * cos * east - across * south,
      -down * sin,
      down * cos * south + across * east,
    ]
    const gravity: Triple = [0, -9.81, 0]
    return clocks.map(([clock, frames]): Case3d => {
      const given = { gravity, normal, velocity, ...rest, frames }
      const name = `a slope that ${what}, kicked ${way}° from down, ${clock}`
      return { name, ...given, rows: finely(given) }
    })
  }),
)

/** Runge–Kutta steps so short that no direction changes much within one, but for the last before the stop. */
function finely({
  gravity,
  normal,
  velocity,
  muStatic,
  muKinetic,
  frames,
}: Omit<Case3d, 'name' | 'rows'>) {
  const weight = product(gravity, normal)
  const drive = sum([1, gravity], [-weight, normal])
  const holds = Math.hypot(...drive) <= Math.max(muStatic, muKinetic) * -weight
  const acceleration = (v: Triple) => sum([1, drive], [(muKinetic * weight) / Math.hypot(...v), v])
  let r: Triple = [0, 0, 0]
  let v = velocity
  return frames.map((frame): Row3d => {
    const count = Math.ceil(frame / FINE)
    const h = frame / count
    for (let i = 0; i < count && Math.hypot(...v) > 0; i++) {
      const a1 = acceleration(v)
      const a2 = acceleration(sum([1, v], [h / 2, a1]))
      const a3 = acceleration(sum([1, v], [h / 2, a2]))
      const a4 = acceleration(sum([1, v], [h, a3]))
      const next = sum([1, v], [h / 6, a1], [h / 3, a2], [h / 3, a3], [h / 6, a4])
      const stops = holds && product(next, v) <= 0
      r = sum([1, r], [h / 2, v], [stops ? 0 : h / 2, next])
      v = stops ? [0, 0, 0] : next
    }
    return [...r, ...v]
  })
}

/** The largest difference between what a step makes of a case and other rows of it [m, m/s]. */
export function furthestOff3d(rows: readonly Row3d[], others: readonly Row3d[]): number {
  return Math.max(
    ...rows.flatMap((row, i) => row.map((each, k) => Math.abs(each - others[i]![k]!))),
  )
}
