/** Sets `drive` and `press` of a motion from its `s` and `v`: what a scene contributes to a step. */
export type Forces = (motion: Motion) => void

/** What a scene's law is besides its forces. */
export interface Law {
  readonly forces: Forces
  /** [kg] */
  readonly mass: number
  /** Coefficients of static and kinetic friction; static is never taken below kinetic. */
  readonly muStatic: number
  readonly muKinetic: number
  /** A force changes with the speed, not with its direction alone. */
  readonly dependsOnSpeed: boolean
  /** The normal force is the same all along the track. */
  readonly constantPress: boolean
  /** The instant at which the speed changes sign matters: a force jumps or has a kink there, or the track has joints. */
  readonly turnMatters: boolean
  /** Where one piece of the track joins the next [m], ascending: piece i ends at joints[i]. */
  readonly joints: readonly number[]
  /** Beyond the first and the last joint there is no track: a block that gets there has left. */
  readonly open: boolean
  /** A speed that only a step which has lost its stability reaches [m/s]. */
  readonly speedLimit: number
}

/**
 * A block on a track, mid-step: the distance `s` along the track [m], the speed `v` = ds/dt [m/s], and what acts on
 * it. One mutable object with number fields, so that a step allocates nothing. The fields start as NaN, which makes
 * an engine store them as floating-point numbers from the first.
 *
 * The law is the same in every scene: dv/dt = drive − slip μk press (Coulomb friction).
 */
export class Motion {
  s = NaN
  v = NaN
  /** The acceleration that `accelerate` found last [m/s²]. */
  a = NaN
  /** Every force along the track but friction, per mass [m/s²]. */
  drive = NaN
  /** Normal force per mass, ≥ 0 [m/s²]. */
  press = NaN
  /** The length of the step to take [s]. */
  dt = NaN
  /** Energy that friction has turned into heat [J]. */
  heat = NaN
  /** How far before the jump that is looked for a tried step ended: negative past it. */
  miss = NaN
  /** How far into the step asked for the motion has got [s]. */
  elapsed = NaN

  /** The slip direction: the side to which friction does not point. */
  slip: -1 | 0 | 1 = 0
  /** Friction keeps to `slip`, instead of taking the sign of each speed it is asked about. */
  slipHeld = true
  /** The piece of track whose law holds, and where that piece begins and ends [m]. */
  piece = 0
  from = NaN
  to = NaN
  /** `a` is the acceleration at the present state. */
  known = false
  /** The acceleration at a step's end serves the next step too, although v is corrected in between. */
  reusable = false
  /** It has neither come to rest nor left the track nor diverged: there is something to step. */
  moving = true
  outcome: 'moving' | 'at-rest' | 'left-the-track' | 'diverged' = 'moving'
  /** How often the acceleration was evaluated. */
  evaluations = 0
  /** Implicit steps whose equation was not solved to rounding. */
  unsolved = 0

  /** The state at the beginning of the step, to which `rewind` returns. */
  startS = NaN
  startV = NaN
  startA = NaN
  startKnown = false

  readonly law: Law
  // What a step reads of the law stands here too, as fields of known kind.
  readonly rubs: boolean
  readonly constantPress: boolean
  readonly turnMatters: boolean
  readonly speedLimit: number = NaN
  /** m μk: times `press` it is the size of kinetic friction [kg]. */
  readonly rubbingMass: number = NaN
  private readonly forces: Forces
  private readonly muKinetic: number = NaN

  constructor(law: Law, s: number, v: number) {
    this.law = law
    this.forces = law.forces
    this.rubs = law.muKinetic > 0
    this.constantPress = law.constantPress
    this.turnMatters = law.turnMatters
    this.speedLimit = law.speedLimit
    this.rubbingMass = law.mass * law.muKinetic
    this.muKinetic = law.muKinetic
    this.s = s
    this.v = v
    this.heat = 0
    this.elapsed = 0
    this.drive = 0
    this.press = 0
    this.slip = v > 0 ? 1 : v < 0 ? -1 : 0
    this.enterPiece()
  }

  /**
   * Sets `a` to dv/dt at the present `s` and `v` [m/s²]. An integrator moves the motion to wherever it wants to look.
   * Numbers come and go in fields, since engines box one that is passed to a function or returned from it.
   */
  accelerate(): void {
    this.evaluations++
    this.forces(this)
    const slip = this.slipHeld ? this.slip : this.v > 0 ? 1 : this.v < 0 ? -1 : 0
    this.a = this.drive - slip * this.muKinetic * this.press
  }

  /** Sets `drive` and `press` to what they are at the present `s` and `v`. */
  feel(): void {
    this.forces(this)
  }

  /** Whether friction keeps to `slip` or takes the sign of v at every evaluation. */
  holdSlip(held: boolean): void {
    const { law } = this
    this.slipHeld = held
    this.reusable = !law.dependsOnSpeed && (held || law.muKinetic === 0)
  }

  /** Notes the state as the beginning of a step. */
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

  /**
   * Finds the piece of track that the block is on, or at a joint the one that it moves into. Returns false where there is
   * no track.
   */
  enterPiece(): boolean {
    const { joints, open } = this.law
    const ahead = this.slip < 0 ? -1 : 1
    let piece = 0
    while (
      piece < joints.length &&
      (ahead > 0 ? this.s >= joints[piece]! : this.s > joints[piece]!)
    )
      piece++
    this.piece = piece
    this.from = piece === 0 ? -Infinity : joints[piece - 1]!
    this.to = piece === joints.length ? Infinity : joints[piece]!
    this.known = false
    return !open || (piece > 0 && piece < joints.length)
  }

  /** Ends the motion: nothing that is left of the step, and no later one, changes it. */
  end(outcome: 'at-rest' | 'left-the-track' | 'diverged'): void {
    this.moving = false
    this.outcome = outcome
  }
}
