import type { ExactMotion, State } from '../../physics/index.ts'

/** The true motion at even times, as plots draw it. */
export interface Samples {
  /** [s] */
  readonly time: Float64Array
  readonly states: readonly Readonly<State>[]
}

/** Enough for a curve to look smooth on the widest plot. */
const COUNT = 361

const kept = new WeakMap<ExactMotion, Samples & { readonly duration: number }>()

/** Samples of a motion from 0 to a duration [s], both included. */
export function samplesOf(exact: ExactMotion, duration: number): Samples {
  const known = kept.get(exact)
  if (known?.duration === duration) return known
  const time = Float64Array.from({ length: COUNT }, (_, i) => (duration * i) / (COUNT - 1))
  const states = Array.from(time, (t) => ({ ...exact(t, { s: 0, v: 0 }) }))
  const samples = { time, states, duration }
  kept.set(exact, samples)
  return samples
}
