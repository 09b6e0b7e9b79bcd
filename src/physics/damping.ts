/*
 * What games multiply a velocity by in each frame so that it dies away, and what they follow a target with. Engines agree
 * on every bit of it: the exponential and the logarithm are made of + − × and ÷.
 */

const LN2 = 0.6931471805599453
/** The frame rate that a factor a frame is chosen at [fps]. */
const CHOSEN_AT = 60

/** One way to take a part of a velocity away in each frame. */
interface Damping {
  readonly id: string
  readonly formula: string
  /** What is left of the velocity after a frame of `dt` [s], at a rate of decay of `k` [1/s]. */
  factor(k: number, dt: number): number
}

/** The ways to damp a velocity, the right one last. */
export const dampings = [
  { id: 'explicit', formula: '1 − k Δt', factor: (k, dt) => Math.max(0, 1 - k * dt) },
  { id: 'implicit', formula: '1 / (1 + k Δt)', factor: (k, dt) => 1 / (1 + k * dt) },
  { id: 'per-frame', formula: 'a number a frame', factor: (k) => decay(k / CHOSEN_AT) },
  { id: 'exponential', formula: 'exp(−k Δt)', factor: (k, dt) => decay(k * dt) },
] as const satisfies readonly Damping[]

export type DampingId = (typeof dampings)[number]['id']

/**
 * Where a body is after each frame of a game that damps it first and moves it then; it starts at 0 with the speed `v`
 * [m].
 */
export function framesOfCoasting(
  id: DampingId,
  { k, v, fps, frames }: { k: number; v: number; fps: number; frames: number },
): number[] {
  const left = dampings.find((each) => each.id === id)!.factor(k, 1 / fps)
  let x = 0
  const path = [x]
  for (let frame = 0; frame < frames; frame++) {
    v *= left
    path.push((x += v / fps))
  }
  return path
}

/** exp(−x), within a few ulp. @param x 0 or more */
export function decay(x: number): number {
  const halvings = Math.round(x / LN2)
  // Beyond this the result is below the smallest number there is.
  if (!(halvings < 1100)) return x > 0 ? 0 : NaN
  const rest = halvings * LN2 - x
  let sum = 1
  for (let i = 16; i > 0; i--) sum = 1 + (sum * rest) / i
  for (let i = 0; i < halvings; i++) sum /= 2
  return sum
}

/** The rate of decay k [1/s] of a game that multiplies by `factor`, above 0 and at most 1, in each frame at `fps`. */
export function decayRate(factor: number, fps: number): number {
  let scaled = factor
  let doublings = 0
  while (scaled < 0.7) {
    scaled *= 2
    doublings++
  }
  // ln x = 2 artanh((x − 1)/(x + 1)).
  const z = (scaled - 1) / (scaled + 1)
  let sum = 0
  for (let power = 29; power > 0; power -= 2) sum = 1 / power + z * z * sum
  return fps * (doublings * LN2 - 2 * z * sum)
}

// #region coast
/** Moves a damped body by `dt` [s]: exact at any frame rate. */
export function coast(body: { x: number; v: number }, k: number, dt: number): void {
  const left = decay(k * dt)
  // The area under v.
  body.x += k === 0 ? body.v * dt : (body.v * (1 - left)) / k
  body.v *= left
}

/** Moves `x` towards a target: the same path at any frame rate. */
export function follow(x: number, target: number, k: number, dt: number): number {
  return target + (x - target) * decay(k * dt)
}
// #endregion
