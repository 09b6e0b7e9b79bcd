import { frictionHolds } from './holds.ts'
import { FAR } from './law.ts'
import type { Law } from './law.ts'
import { Resistance } from './resistance.ts'
import { C10, C12, C14, C4, C6, C8, S11, S13, S3, S5, S7, S9, SinCos } from './trigonometry.ts'

/** Called after each evaluation of the acceleration, at `atS` and `atV`. */
export type Observer = (motion: Motion) => void

/**
 * A block on a track: the distance `s` along the track [m], the speed `v` = ds/dt [m/s], and the law that moves it.
 * One mutable object with number fields, so that a step allocates nothing. Most fields start as NaN so that engines
 * store them as floating-point numbers from the start.
 */
export class Motion {
  s = NaN
  v = NaN
  /** The length of the step to take; once it has been taken, its actual length [s]. */
  dt = NaN
  /** Time since the start of the step that the timestep policy asked for [s]. */
  elapsed = NaN
  outcome: 'moving' | 'at-rest' | 'left-the-track' | 'diverged' = 'moving'
  /** Energy that friction and drag have turned into heat [J]. */
  heat = NaN
  /** The work of a moving belt on the block [J]. */
  work = NaN
  /** How often the acceleration was evaluated. */
  evaluations = 0
  /** Implicit steps whose equation was not solved to rounding. */
  unsolved = 0

  /** The direction of sliding, which friction opposes. */
  slip: -1 | 0 | 1 = 0
  /** Friction opposes `slip` throughout a step, instead of the sign of each speed at which it is evaluated. */
  readonly slipHeld: boolean
  /** The acceleration at the present state if `known`; a step may pass it on to the next [m/s²]. */
  a = NaN
  known = false
  /** The acceleration does not depend on the speed here, so that one evaluation serves two steps. */
  reusable = false

  // The piece of track that the block is on: its law holds from one distance to the other [m].
  from = NaN
  to = NaN
  curvature = NaN
  // The direction of that piece below the horizontal [rad], at a distance along it [m].
  private slope = NaN
  private at = NaN
  /** Gravity along the track and into it, per mass; on a bend, at the distance of the last evaluation [m/s²]. */
  tangential = NaN
  weight = NaN
  /** The slip direction times the coefficient of kinetic friction. */
  friction = NaN
  /** The acceleration is constant along the piece: a straight, with gravity and friction alone [m/s²]. */
  private isSteady = false
  private steady = NaN
  /** The normal force per mass, N/m, at the present state; on a bend only after `findPress` [m/s²]. */
  press = NaN
  /** The state at which the acceleration is evaluated, and its value there [m, m/s, m/s²]. */
  atS = NaN
  atV = NaN
  atA = NaN
  // The inverse of the longest sensible step on this piece: at rest [1/s], and per m/s of speed [1/m].
  rate = NaN
  ratePerSpeed = NaN
  /** Friction and drag at the end of the last step. */
  resistance = Resistance.pair()

  /** The state at which the step began, to which `rewind` returns. */
  startS = NaN
  startV = NaN
  private startA = NaN
  private startKnown = false

  readonly law: Law
  private observer: Observer | undefined
  private readonly direction = new SinCos()

  constructor(law: Law, s: number, v: number, slipHeld: boolean) {
    this.law = law
    this.slipHeld = slipHeld
    this.s = s
    this.v = v
    this.heat = this.work = this.elapsed = 0
    this.slide(v > law.belt ? 1 : v < law.belt ? -1 : 0)
    this.enterPiece()
    if (this.isLifted()) this.end('left-the-track')
  }

  /** The block is neither at rest nor off the track, and has not diverged. */
  get moving(): boolean {
    return this.outcome === 'moving'
  }

  /**
   * dv/dt at a distance along the track and a speed [m/s²], for integrators. It is so short that V8 inlines it
   * into every integrator and boxes no arguments; the law itself reads and writes fields, and is too long to be inlined
   * here, which would make this too long for integrators.
   */
  acceleration(s: number, v: number): number {
    this.atS = s
    this.atV = v
    this.evaluate()
    return this.atA
  }

  /** The law of motion of every scene: sets `atA` to dv/dt at `atS` and `atV`. */
  private evaluate(): void {
    this.evaluations++
    if (this.isSteady) {
      this.atA = this.steady
      return
    }
    const { atS: s, atV: v } = this
    if (this.curvature !== 0) {
      // For angles below π/4 this is SinCos.find written out: a call would take as long as the arithmetic.
      const angle = this.slope - this.curvature * (s - this.at)
      const z = angle * angle
      if (z < 0.6) {
        const w = z * z
        const sineTail = S3 + z * (S5 + z * (S7 + z * S9) + z * w * (S11 + z * S13))
        const cosineTail = C4 + z * (C6 + z * C8) + z * w * (C10 + z * (C12 + z * C14))
        const head = 1 - 0.5 * z
        this.tangential = this.law.gravity * (angle + angle * z * sineTail)
        this.weight = this.law.gravity * (head + (1 - head - 0.5 * z + w * cosineTail))
      } else this.turn()
    }
    if (!this.slipHeld) this.slide(v > this.law.belt ? 1 : v < this.law.belt ? -1 : 0)
    const { stiffness, drag } = this.law
    // #region law
    const drive = this.tangential - stiffness * s - drag * v * Math.abs(v)
    const press = this.weight + this.curvature * (v * v)
    this.atA = drive - this.friction * press
    // #endregion
    if (this.observer !== undefined) this.observer(this)
  }

  /** Sets `tangential` and `weight`, the two parts of gravity, at `atS` on a bend. */
  turn(): void {
    const { direction, law } = this
    // #region turn
    direction.angle = this.slope - this.curvature * (this.atS - this.at)
    direction.find()
    this.tangential = law.gravity * direction.sin
    this.weight = law.gravity * direction.cos
    // #endregion
  }

  /** Sets `press` to the normal force per mass where the block is now, on a bend. */
  findPress(): void {
    this.atS = this.s
    this.turn()
    this.press = this.weight + this.curvature * (this.v * this.v)
  }

  /** Whether the press is negative: on a crest, the block is too fast to stay on the track. */
  isLifted(): boolean {
    if (this.curvature >= 0) return false
    this.findPress()
    return this.press < 0
  }

  /** Sets the slip direction, which friction opposes from now on. */
  slide(slip: -1 | 0 | 1): void {
    this.slip = slip
    this.friction = slip * this.law.muKinetic
    this.resistance.s = NaN
    this.steady = this.tangential - this.friction * this.weight
  }

  /** Calls `observer` after each evaluation of the acceleration; undefined removes it. */
  observe(observer: Observer | undefined): void {
    const { law, slipHeld, curvature } = this
    this.observer = observer
    this.isSteady =
      observer === undefined && slipHeld && curvature === 0 && law.stiffness === 0 && law.drag === 0
  }

  /**
   * Finds the piece of track that the block is on, or at a joint the one that it slides into, and adopts its law.
   * Returns false where there is no track.
   */
  enterPiece(): boolean {
    const { s, slip, law } = this
    const { track, gravity, muKinetic } = law
    let i = 0
    while (i < track.length - 1 && (slip < 0 ? s > track[i]!.to : s >= track[i]!.to)) i++
    const piece = track[i]!
    this.from = Math.max(piece.from, -FAR)
    this.to = Math.min(piece.to, FAR)
    this.curvature = piece.curvature
    this.slope = piece.slope
    this.at = piece.at
    this.tangential = gravity * piece.sin
    this.weight = gravity * piece.cos
    this.known = false
    this.observe(this.observer)
    this.slide(slip)
    this.reusable = law.drag === 0 && (muKinetic === 0 || (this.slipHeld && piece.curvature === 0))
    const bend = Math.abs(piece.curvature)
    this.rate = 0.5 * Math.sqrt(gravity * bend * (1 + muKinetic))
    if (law.turnMatters) this.rate += Math.sqrt(law.stiffness) / Math.PI
    this.ratePerSpeed = bend * (0.5 + muKinetic)
    return slip < 0 ? s > piece.from && s <= piece.to : s >= piece.from && s < piece.to
  }

  /**
   * Decides for a block that does not slide whether it sets off: static friction holds it while |drive| ≤ μs press.
   * Otherwise it sets off along the drive. A block that is held is at rest, or rides on a belt.
   */
  setsOff(): boolean {
    // #region rest
    this.slide(0)
    const drive = this.acceleration(this.s, this.law.belt)
    const terms = Math.abs(this.tangential) + Math.abs(this.law.stiffness * this.s)
    if (frictionHolds(drive, this.law.muStatic * this.weight, terms)) {
      if (this.law.belt === 0) this.end('at-rest')
      return false
    }
    this.slide(drive > 0 ? 1 : -1)
    // #endregion
    // At a joint it sets off into the piece on that side.
    if (this.enterPiece()) return true
    this.end('left-the-track')
    return false
  }

  /** Records the state as the start of a step. */
  begin(): void {
    this.startS = this.s
    this.startV = this.v
    this.startA = this.a
    this.startKnown = this.known
  }

  /** Returns to the start of the step. */
  rewind(): void {
    this.s = this.startS
    this.v = this.startV
    this.a = this.startA
    this.known = this.startKnown
  }

  /** Ends the sliding where the block is. */
  stop(): void {
    this.v = this.law.belt
  }

  /** Ends the motion: neither the rest of the step nor any later step changes it. */
  end(outcome: 'at-rest' | 'left-the-track' | 'diverged'): void {
    this.outcome = outcome
  }
}
