import type { ExactMotion } from '../state.ts'
import type { Track } from '../track.ts'
import { evaluate } from './phase.ts'
import { Slide } from './slide.ts'
import type { TrackParameters } from './slide.ts'

// 3.5 MB, or 20 minutes in the half-pipe. That is as far as rounding, which grows with the phases, stays below 1e-11 or
// below 100 times what the last bits of the parameters change. Only μk < 0.001 takes longer to stop.
const MOST_PHASES = 8192

/**
 * A motion on a track of straights and arcs, with friction: parabolas on the straights, Taylor series on the arcs, each
 * up to a stop or a joint. A block that reaches an outer end of the track has left it: from then on its
 * state stays as it was there. NaN at times beyond `MOST_PHASES`, and from any phase on that does not
 * keep its energy to rounding.
 */
export function exactTrack(track: Track, parameters: TrackParameters): ExactMotion {
  const slide = new Slide(track, parameters)
  const { turns } = slide
  // When each phase begins [s], and the phases, computed as far as the latest requested time.
  const starts = [slide.time]
  const phases = [slide.next()]
  let found = 0

  /**
   * Computes the phases up to a time. Returns it, or for a periodic motion its equivalent in the first period, or NaN.
   */
  function reach(t: number): number {
    while (t >= slide.time && turns.length < 3 && phases.length < MOST_PHASES) {
      starts.push(slide.time)
      phases.push(slide.next())
    }
    if (t < slide.time) return t
    // Without kinetic friction, a motion between two turning points is periodic, so no error grows with the swings.
    return turns.length < 3 ? NaN : turns[0]! + ((t - turns[0]!) % (turns[2]! - turns[0]!))
  }

  const hasBegun = (i: number, t: number) => i < starts.length && starts[i]! <= t

  /** The index of the last phase that has begun by a time. */
  function find(t: number): number {
    if (hasBegun(found, t) && !hasBegun(found + 1, t)) return found
    let low = 0
    let high = starts.length
    while (high - low > 1) {
      const middle = (low + high) >> 1
      if (hasBegun(middle, t)) low = middle
      else high = middle
    }
    return (found = low)
  }

  return (t, into) => {
    const time = reach(t)
    const i = find(time)
    const { c, unit, end } = phases[i]!
    if (c.length === 1) {
      into.s = end.s
      into.v = end.v
      return into
    }
    evaluate(c, (time - starts[i]!) / unit, into)
    into.v /= unit
    return into
  }
}
