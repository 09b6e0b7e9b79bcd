import { simulate } from '../../../src/physics/index.ts'
import type { Experiment } from '../../../src/physics/index.ts'
import { cases3d } from './cases3d.ts'
import type { Row3d } from './cases3d.ts'

/** A slide on a ramp for the take-home step, and what `simulate` makes of it, frame by frame. */
export interface Case {
  readonly name: string
  /** Of the ramp, with y upwards. */
  readonly gravity: readonly [number, number]
  readonly normal: readonly [number, number]
  readonly along: readonly [number, number]
  readonly muStatic: number
  readonly muKinetic: number
  readonly speed: number
  /** How long each frame lasts [s]. */
  readonly frames: readonly number[]
  readonly s: readonly number[]
  readonly v: readonly number[]
}

const slides = [
  { what: 'stops uphill and stays', angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  { what: 'stops uphill and comes back', angle: 35, muStatic: 0.3, muKinetic: 0.2, speed: -5 },
  { what: 'stops downhill and stays', angle: 10, muStatic: 0.4, muKinetic: 0.4, speed: 3 },
  { what: 'stays where it is put', angle: 15, muStatic: 0.5, muKinetic: 0.4, speed: 0 },
  { what: 'sets off', angle: 30, muStatic: 0.3, muKinetic: 0.2, speed: 0 },
  { what: 'slides on the flat and stops', angle: 0, muStatic: 0.3, muKinetic: 0.3, speed: 4 },
  { what: 'slides without friction', angle: 20, muStatic: 0, muKinetic: 0, speed: -3 },
]

const clocks = [
  ...[5, 10, 30, 60, 144].map((fps) => ({ kind: 'steady', fps }) as const),
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 1 },
  { kind: 'hitch', fps: 60, every: 0.4, length: 0.35 },
] as const

/** Every slide under every clock, two seconds each. */
export const cases: readonly Case[] = slides.flatMap(({ what, angle, ...rest }) =>
  clocks.map((frames): Case => {
    const experiment: Experiment = {
      scene: 'ramp',
      parameters: { angle, ...rest },
      frames,
      duration: 2,
    }
    const { time, s, v } = simulate(experiment)
    const sin = Math.sin((angle * Math.PI) / 180)
    const cos = Math.cos((angle * Math.PI) / 180)
    return {
      name: `${what}, ${frames.kind} ${frames.fps} fps`,
      gravity: [0, -9.81],
      normal: [sin, cos],
      along: [cos, -sin],
      ...rest,
      frames: [...time.subarray(1)].map((end, i) => end - time[i]!),
      s: [...s],
      v: [...v],
    }
  }),
)

/** Position and velocity after each frame, x and y. */
export type Row = readonly [number, number, number, number]

/**
 * The largest difference between what a step makes of a case and what `simulate` does, along the ramp and off it [m, m/s],
 * relative to the motion's size where that is more than 1.
 */
export function furthestOff({ along, normal, s, v }: Case, rows: readonly Row[]): number {
  const size = Math.max(1, ...s.map(Math.abs), ...v.map(Math.abs))
  return Math.max(
    ...rows.flatMap(([x, y, u, w], i) => [
      Math.abs(x * along[0] + y * along[1] - s[i + 1]!) / size,
      Math.abs(u * along[0] + w * along[1] - v[i + 1]!) / size,
      Math.abs(x * normal[0] + y * normal[1]) / size,
    ]),
  )
}

/** What a program reads: a case a line. Dimensions, start velocity, gravity, normal, both μ, then the frames. */
export function casesText(): string {
  const flat = cases.map(({ along, speed, ...rest }) => ({
    ...{ ...rest, velocity: [along[0] * speed, along[1] * speed] },
  }))
  return [...flat, ...cases3d]
    .map(({ velocity, gravity, normal, muStatic, muKinetic, frames }) =>
      [velocity.length, ...velocity, ...gravity, ...normal, muStatic, muKinetic, ...frames]
        .map((value) => value.toString())
        .join(' '),
    )
    .join('\n')
}

/** What a program writes: `row x y u w`, in space `row x y z u v w`, for every frame of every case; the rest is the tool's own. */
export function rowsOf(output: string): { flat: Row[][]; inSpace: Row3d[][] } {
  const rows = output
    .split(/\r?\n/)
    .filter((line) => line.startsWith('row '))
    .map((line) => line.split(' ').slice(1).map(Number))
  let from = 0
  const next = ({ frames }: { frames: readonly number[] }) =>
    rows.slice(from, (from += frames.length))
  return {
    flat: cases.map(next) as unknown as Row[][],
    inSpace: cases3d.map(next) as unknown as Row3d[][],
  }
}
