import { Resistance } from './heat.ts'
import { holds } from './holds.ts'
import { FAR } from './law.ts'
import type { Law } from './law.ts'
import { SinCos } from './trigonometry.ts'

/** Is told of each evaluation of the acceleration, at `atS` and `atV`. */
export type Observer = (motion: Motion) => void

/**
 * A block on a track: the distance `s` along the track [m], the speed `v` = ds/dt [m/s], and the law that moves it.
 * One mutable object with number fields, so that a step allocates nothing. Most fields start as NaN so that engines
 * store them as floating-point numbers from the first.
 */
export class Motion {
  s = NaN
  v = NaN
  /** The length of the step to take; once it has been taken, how long it was [s]. */
  dt = NaN
  /** How far into the step that the timestep policy asked for the motion has got [s]. */
  elapsed = NaN
  outcome: 'moving' | 'at-rest' | 'left-the-track' | 'diverged' = 'moving'
  /** Energy that friction and drag have turned into heat [J]. */
  heat = NaN
  /** How often the acceleration was evaluated. */
  evaluations = 0
  /** Implicit steps whose equation was not solved to rounding. */
  unsolved = 0

  /** The direction of sliding, which friction opposes. */
  slip: -1 | 0 | 1 = 0
  /** Friction opposes `slip` all through a step, instead of the sign of each speed that it is evaluated at. */
  readonly slipHeld: boolean
  /** The acceleration at the present state, where `known`: what a step may hand on to the next [m/s²]. */
  a = NaN
  known = false
  /** The acceleration here does not depend on the speed, so that one evaluation serves two steps. */
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
  /** The acceleration is one number all along the piece: by gravity and friction alone, on a straight [m/s²]. */
  private isSteady = false
  private steady = NaN
  /** Where the acceleration is evaluated, and what it is there [m, m/s, m/s²]. */
  atS = NaN
  atV = NaN
  atA = NaN
  // The inverse of the longest step that makes sense here: at rest [1/s], and what each m/s adds [1/m].
  rate = NaN
  ratePerSpeed = NaN
  /** What resisted at the end of the last step. */
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
    this.heat = this.elapsed = 0
    this.slide(v > 0 ? 1 : v < 0 ? -1 : 0)
    this.enterPiece()
  }

  /** It has neither come to rest nor left the track nor diverged: there is something to step. */
  get moving(): boolean {
    return this.outcome === 'moving'
  }

  /**
   * dv/dt at a distance along the track and a speed [m/s²]: what an integrator asks for. So short that V8 compiles it
   * into every integrator, where no number need be boxed to be passed: the law reads and writes fields.
   */
  acceleration(s: number, v: number): number {
    this.atS = s
    this.atV = v
    this.evaluate()
    return this.atA
  }

  /** The law of motion of every scene: sets `atA` to what dv/dt is at `atS` and `atV`. */
  private evaluate(): void {
    this.evaluations++
    if (this.isSteady) {
      this.atA = this.steady
      return
    }
    const { atS: s, atV: v, law } = this
    if (this.curvature !== 0) this.turn()
    if (!this.slipHeld) this.slide(v > 0 ? 1 : v < 0 ? -1 : 0)
    // #region law
    const drive = this.tangential - law.stiffness * s - law.drag * v * Math.abs(v)
    const press = this.weight + this.curvature * (v * v)
    this.atA = drive - this.friction * press
    // #endregion
    if (this.observer !== undefined) this.observer(this)
  }

  /** Sets `tangential` and `weight` to what gravity comes to at `atS` on a bend. */
  turn(): void {
    const { direction, law } = this
    direction.angle = this.slope - this.curvature * (this.atS - this.at)
    direction.find()
    this.tangential = law.gravity * direction.sin
    this.weight = law.gravity * direction.cos
  }

  /** Takes a direction of sliding, which friction opposes from now on. */
  slide(slip: -1 | 0 | 1): void {
    this.slip = slip
    this.friction = slip * this.law.muKinetic
    this.resistance.s = NaN
    this.steady = this.tangential - this.friction * this.weight
  }

  /** Has each evaluation of the acceleration shown to somebody, or to nobody. */
  observe(observer: Observer | undefined): void {
    const { law, slipHeld, curvature } = this
    this.observer = observer
    this.isSteady =
      observer === undefined && slipHeld && curvature === 0 && law.stiffness === 0 && law.drag === 0
  }

  /**
   * Finds the piece of track that the block is on, or at a joint the one that it slides into, and takes up its law.
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
   * Decides for a block with v = 0 whether it moves: static friction holds it while |drive| ≤ μs press. Otherwise it
   * sets off along the drive.
   */
  // #region rest
  setsOff(): boolean {
    this.slide(0)
    const drive = this.acceleration(this.s, 0)
    const terms = Math.abs(this.tangential) + Math.abs(this.law.stiffness * this.s)
    if (holds(drive, this.law.muStatic * this.weight, terms)) {
      this.end('at-rest')
      return false
    }
    this.slide(drive > 0 ? 1 : -1)
    // At a joint it sets off into the piece on that side.
    if (this.enterPiece()) return true
    this.end('left-the-track')
    return false
  }
  // #endregion

  /** Notes the state as the beginning of a step of that length [s]. */
  begin(): void {
    this.startS = this.s
    this.startV = this.v
    this.startA = this.a
    this.startKnown = this.known
  }

  /** Returns to the beginning of the step. */
  rewind(): void {
    this.s = this.startS
    this.v = this.startV
    this.a = this.startA
    this.known = this.startKnown
  }

  /** Brings the block to rest where it is. */
  stop(): void {
    this.v = 0
    this.known = false
  }

  /** Ends the motion: nothing that is left of the step, and no later one, changes it. */
  end(outcome: 'at-rest' | 'left-the-track' | 'diverged'): void {
    this.outcome = outcome
  }
}
