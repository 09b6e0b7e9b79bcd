import type { ExactMotion } from '../physics/index.ts'

/** Instants of the true motion, in order of time, from 0 to a duration, both included. */
export interface Samples {
  /** [s] */
  readonly time: Float64Array
  /** [m] */
  readonly s: Float64Array
  /** [m/s] */
  readonly v: Float64Array
  /**
   * Up to this row straight lines between the samples can't be told from the motion on a screen. Beyond it there were more
   * swings than could be followed: samples here and there, which show how far they go.
   */
  readonly followed: number
}

/** A fraction of the ranges of s and v: half a pixel of a large plot. */
const TOLERANCE = 1 / 500
/** What every motion is looked at: intervals of the same length, each of which may turn out to need more. */
const INTERVALS = 64
/** How far from both its ends an interval is tried [of its length]: not where swings come round to the same place. */
const INSIDE = (3 - Math.sqrt(5)) / 2
/** Some four hundred swings. */
const MOST = 12_000
/** For what could not be followed. */
const SCATTERED = 4000

const kept = new WeakMap<ExactMotion, Samples & { readonly duration: number }>()

/** Samples of a motion up to a duration [s], close to each other where it turns and swings. */
export function samplesOf(exact: ExactMotion, duration: number): Samples {
  const known = kept.get(exact)
  if (known?.duration === duration) return known
  const samples = { ...sample(exact, duration), duration }
  kept.set(exact, samples)
  return samples
}

function sample(exact: ExactMotion, duration: number): Samples {
  const state = { s: 0, v: 0 }
  const reach = { s: new Reach(), v: new Reach() }
  const at = (time: number): Instant => {
    const { s, v } = exact(time, state)
    reach.s.take(s)
    reach.v.take(v)
    return { time, s, v }
  }
  const isStraight = (from: Instant, inside: Instant, to: Instant) => {
    const part = (inside.time - from.time) / (to.time - from.time)
    // Written so that NaN needs no more samples.
    return !(
      Math.abs(from.s + part * (to.s - from.s) - inside.s) > reach.s.tolerance ||
      Math.abs(from.v + part * (to.v - from.v) - inside.v) > reach.v.tolerance
    )
  }

  // The last comes first: those that are still to be reached, the next on top.
  const ahead = Array.from({ length: INTERVALS }, (_, i) => at(duration * (1 - i / INTERVALS)))
  const taken = [at(0)]
  const least = duration * 1e-9
  while (ahead.length > 0 && taken.length < MOST) {
    const from = taken.at(-1)!
    const to = ahead.at(-1)!
    const length = to.time - from.time
    const inside = at(from.time + INSIDE * length)
    const isLine =
      isStraight(from, inside, to) && isStraight(from, at(to.time - INSIDE * length), to)
    if (isLine || length <= least) taken.push(ahead.pop()!)
    else ahead.push(inside)
  }
  const followed = taken.length - 1
  if (ahead.length > 0) {
    const from = taken.at(-1)!.time
    const each = (duration - from) / SCATTERED
    for (let i = 1; i < SCATTERED; i++) taken.push(at(from + each * (i + ((i * INSIDE) % 1) - 0.5)))
    taken.push(at(duration))
  }
  return {
    time: Float64Array.from(taken, ({ time }) => time),
    s: Float64Array.from(taken, ({ s }) => s),
    v: Float64Array.from(taken, ({ v }) => v),
    followed,
  }
}

interface Instant {
  readonly time: number
  readonly s: number
  readonly v: number
}

/** What a value has ranged over so far. */
class Reach {
  private least = Infinity
  private most = -Infinity

  take(value: number): void {
    if (value < this.least) this.least = value
    if (value > this.most) this.most = value
  }

  /** Never so small that rounding would look like a curve. */
  get tolerance(): number {
    const size = Math.max(Math.abs(this.least), Math.abs(this.most))
    return Math.max(TOLERANCE * (this.most - this.least), 1e-12 * size)
  }
}
