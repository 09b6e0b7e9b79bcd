import type { ExactMotion, State } from '../scene.ts'
import type { Track } from '../track.ts'
import { DEGREE, evaluate } from './phase.ts'
import { Slide } from './slide.ts'
import type { TrackParameters } from './slide.ts'

// A row is one phase: these, then the coefficients.
const START = 0
const UNIT = 1
const SPEED = 2
const PHASE_DEGREE = 3
const COEFFICIENTS = 4
const ROW = COEFFICIENTS + DEGREE + 1

// 1.9 MB, or 20 minutes in the half-pipe. That is as far as rounding, which grows with the phases, stays below 1e-11 or
// below 100 times what the last bits of the parameters change. Only kinetic friction below 0.001 takes longer to stop.
const MOST_PHASES = 8192

/**
 * A motion on a track of straights and arcs, with friction: parabolas on the straights, Taylor series on the arcs, each
 * up to the instant of a stop or a joint. A block that reaches an outer end of the track has left it: from then on its
 * state is the one that it had there. NaN at a time that `MOST_PHASES` do not reach, and from a phase on that does not
 * keep its energy to rounding.
 */
export function exactTrack(track: Track, parameters: TrackParameters): ExactMotion {
  const phases = new Phases(new Slide(track, parameters))
  return (t, into) => phases.state(t, into)
}

/** The phases of a motion, computed as later times are asked for. */
class Phases {
  private rows = new Float64Array(8 * ROW)
  private count = 0
  /** The row found last. */
  private found = 0
  private readonly slide: Slide

  constructor(slide: Slide) {
    this.slide = slide
  }

  state(t: number, into: State): State {
    const time = this.reach(t)
    const row = this.find(time) * ROW
    const { rows } = this
    const degree = rows[row + PHASE_DEGREE]!
    if (degree === 0) {
      into.s = rows[row + COEFFICIENTS]!
      into.v = rows[row + SPEED]!
      return into
    }
    const unit = rows[row + UNIT]!
    evaluate(rows, row + COEFFICIENTS, degree, (time - rows[row + START]!) / unit, into)
    into.v /= unit
    return into
  }

  /** Computes the phases up to a time. Returns that time, or the one in the first period that it repeats, or NaN. */
  private reach(t: number): number {
    const { slide } = this
    const { turns } = slide
    while (t >= slide.time && slide.time < Infinity && turns.length < 3) {
      if (this.count === MOST_PHASES) return NaN
      this.append()
    }
    if (t < slide.time || turns.length < 3) return t
    // Without kinetic friction, and between two turning points, the motion is periodic: no error grows with the swings.
    return turns[0]! + ((t - turns[0]!) % (turns[2]! - turns[0]!))
  }

  private append(): void {
    const { slide } = this
    const { phase } = slide
    slide.next()
    const row = this.count++ * ROW
    if (row === this.rows.length) {
      const larger = new Float64Array(2 * row)
      larger.set(this.rows)
      this.rows = larger
    }
    const { rows } = this
    rows[row + START] = slide.start
    rows[row + UNIT] = phase.unit
    rows[row + SPEED] = phase.end.v
    rows[row + PHASE_DEGREE] = phase.degree
    rows.set(phase.c, row + COEFFICIENTS)
  }

  /** The row of the last phase that has begun by a time. */
  private find(t: number): number {
    const { rows, count, found } = this
    const isLater = (row: number) => row < count && rows[row * ROW]! <= t
    if (isLater(found) && !isLater(found + 1)) return found
    let low = 0
    let high = count
    while (high - low > 1) {
      const middle = (low + high) >> 1
      if (isLater(middle)) low = middle
      else high = middle
    }
    return (this.found = low)
  }
}
