import { ExactSum } from '../exactSum.ts'
import { frictionHolds } from '../holds.ts'
import type { Piece, Track } from '../track.ts'
import { slideArc } from './arc.ts'
import { stay } from './phase.ts'
import type { Phase } from './phase.ts'
import { slideStraight } from './straight.ts'

/** The start of a motion on a track, and the constants of its law. */
export interface TrackParameters {
  readonly gravity: number
  readonly muStatic: number
  readonly muKinetic: number
  readonly position: number
  readonly speed: number
}

/** A block on a track, moving from one phase of its motion to the next. */
export class Slide {
  /** When the next phase begins [s]: a sum of the phases so far, rounded once. */
  time = 0
  /** When a block without kinetic friction set off from v = 0 [s]: from the third time on, the motion repeats. */
  readonly turns: number[] = []

  private readonly lasted = new ExactSum()
  private s: number
  private v: number
  /** The slip direction; while the block rests, that of the motion before. */
  private slip: 1 | -1 | 0
  private hasLeft = false
  private readonly track: Track
  private readonly gravity: number
  private readonly muKinetic: number
  /** Static friction, never taken below kinetic. */
  private readonly muHold: number

  constructor(track: Track, { gravity, muStatic, muKinetic, position, speed }: TrackParameters) {
    this.track = track
    this.gravity = gravity
    this.muKinetic = muKinetic
    this.muHold = Math.max(muStatic, muKinetic)
    this.s = position
    this.v = speed
    this.slip = speed > 0 ? 1 : speed < 0 ? -1 : 0
  }

  /** Advances by one phase: up to a change of the law, for one step of a series, or for ever. */
  next(): Phase {
    const phase = this.phase()
    // Infinity has no low part, and no phase follows it.
    if (phase.lasts < Infinity) this.lasted.add(phase.lasts)
    this.time = phase.lasts < Infinity ? this.lasted.value : Infinity
    this.s = phase.end.s
    this.v = phase.end.v
    this.hasLeft = phase.takesOff ?? false
    return phase
  }

  private phase(): Phase {
    const { gravity, muKinetic, s, v } = this
    if (this.hasLeft) return stay(s, v)
    const moves = v !== 0 || this.setsOff()
    const { slip } = this
    const piece = this.pieceTowards(slip)
    if (!moves || slip === 0 || !piece || this.isLifted(piece)) return stay(s, v)
    const mu = slip * muKinetic
    if (piece.curvature !== 0) return slideArc(s, v, slip, mu, gravity, piece)
    const a = gravity * piece.sin - mu * (gravity * piece.cos)
    return slideStraight(s, v, slip, a, slip > 0 ? piece.to : piece.from)
  }

  /** Decides whether a block with v = 0 sets off; if so, sets the slip direction. */
  private setsOff(): boolean {
    const here = this.pieceTowards(1) ?? this.pieceTowards(-1)
    if (!here) return false
    const direction = Math.sign(this.drive(here))
    // Friction holds what it has stopped. Without this, rounding could release a block that moves by less than an ulp.
    if (direction === this.slip || direction === 0) return false
    const ahead = this.pieceTowards(direction)
    if (!ahead) return false
    const drive = this.drive(ahead)
    if (frictionHolds(drive, this.muHold * this.press(ahead), Math.abs(drive))) return false
    this.slip = direction > 0 ? 1 : -1
    if (this.muKinetic === 0) this.turns.push(this.time)
    return true
  }

  /** The piece on which a block moves, or which it enters; undefined where the track ends. */
  private pieceTowards(direction: number): Piece | undefined {
    const { track, s } = this
    return direction > 0
      ? track.find(({ from, to }) => from <= s && s < to)
      : track.find(({ from, to }) => from < s && s <= to)
  }

  /** Gravity along the piece, and into it: the normal force per mass at v = 0 [m/s²]. */
  private drive(piece: Piece): number {
    return this.gravity * (piece.curvature === 0 ? piece.sin : Math.sin(this.slope(piece)))
  }

  private press(piece: Piece): number {
    return this.gravity * (piece.curvature === 0 ? piece.cos : Math.cos(this.slope(piece)))
  }

  /** Whether a block on a crest is too fast to stay on the track. */
  private isLifted(piece: Piece): boolean {
    return piece.curvature < 0 && this.press(piece) + piece.curvature * this.v * this.v < 0
  }

  private slope({ slope, curvature, at }: Piece): number {
    return slope - curvature * (this.s - at)
  }
}
