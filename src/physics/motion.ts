import { apart } from './apart.ts'
import { Contact, feltOn } from './law.ts'
import type { Forces, Law } from './law.ts'
import type { MotionLog } from './motionLog.ts'

// What starts 1e9 m away and falls at 1e6 m/s² for 1e6 s does not get near it [m].
export const FAR = 1e24

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
  /** The acceleration that serves the next step too, where `known` [m/s²]. */
  a = NaN
  /** Every force along the track but friction, per mass, and the normal force per mass, as `feel` found them [m/s²]. */
  drive = NaN
  press = NaN
  /** The length of the step to take [s]. */
  dt = NaN
  /** How many such steps are left to take in a row; 0 while they are tried one by one. */
  left = 0
  /** All that the next step needs for one of a row is known. */
  inRow = false
  /** Where the steps of a row are noted. */
  log: MotionLog | undefined
  /** Energy that friction has turned into heat [J]. */
  heat = NaN
  /** How far before the jump that is looked for a tried step ended: negative past it. */
  miss = NaN
  /** How far into the step asked for the motion has got [s]. */
  elapsed = NaN

  /** The slip direction: the side to which friction does not point. Whoever changes it calls `enterPiece` after that. */
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
  /** The method is of higher order than the second: the sum of the heat has to be, too. */
  accurate = false

  /** The state at the beginning of the step, to which `rewind` returns. */
  startS = NaN
  startV = NaN
  startA = NaN
  startKnown = false

  readonly law: Law
  private readonly muKinetic: number = NaN
  private readonly contact = new Contact()
  private readonly asked: readonly Forces[]

  // The law of the piece, with friction to the side that the slip direction gives it.
  // How the acceleration is found: it is one number, or one term more; if neither, the forces are asked for.
  private isSteady = false
  private hasSpring = false
  private hasDrag = false
  private forces: Forces
  private steady = NaN
  private evenDrive = NaN
  private perMetre = NaN
  private perSquare = NaN
  private friction = NaN
  private askedS = NaN
  private askedV = NaN
  private answer = NaN
  /** Friction [N], where the normal force is the same all along the piece. */
  private rubbing = NaN
  private pressChanges = false
  /** The normal force per mass at the end of the last step, where it changes along the piece [m/s²]. */
  private pressed = NaN
  private endS = NaN
  private endV = NaN
  // A step that ends between these has met no jump of the law.
  private low = NaN
  private high = NaN
  private slowest = NaN
  private fastest = NaN
  // What a refused step has counted is taken back.
  private keptEvaluations = 0
  private unsolvedAt = -1

  constructor(law: Law, s: number, v: number) {
    this.law = law
    this.muKinetic = law.muKinetic
    this.asked = law.forces.map(feltOn)
    this.forces = this.asked[0]!
    this.s = s
    this.v = v
    this.heat = 0
    this.elapsed = 0
    this.slip = v > 0 ? 1 : v < 0 ? -1 : 0
    this.enterPiece()
  }

  /**
   * dv/dt at a distance and a speed of the present piece [m/s²]: what an integrator asks for. Short, so that an engine
   * compiles it into every integrator, and no number is boxed.
   */
  acceleration(s: number, v: number): number {
    this.evaluations++
    if (this.isSteady) return this.steady
    if (this.hasSpring) return this.evenDrive - this.perMetre * s - this.friction
    if (this.hasDrag) return this.evenDrive - this.perSquare * v * Math.abs(v)
    this.askedS = s
    this.askedV = v
    apart(Motion.accelerate, this)
    return this.answer
  }

  private static accelerate(motion: Motion): void {
    const { contact, forces, askedV: v } = motion
    contact.s = motion.askedS
    contact.v = v
    forces(contact)
    // #region accelerate
    const slip = motion.slipHeld ? motion.slip : v > 0 ? 1 : v < 0 ? -1 : 0
    motion.answer = contact.drive - slip * motion.muKinetic * contact.press
    // #endregion
  }

  /**
   * Ends a step at a distance and a speed: what an integrator calls. Returns whether it goes on from there with another. A step
   * of those in a row that met a jump of the law is not kept: the stopping rule takes it again.
   */
  goesOn(s: number, v: number): boolean {
    if (this.left > 0) {
      if (!(v > this.slowest && v < this.fastest && s > this.low && s < this.high)) return false
      if (this.pressChanges) {
        this.endS = s
        this.endV = v
        apart(Motion.rubAlong, this)
      } else this.heat += this.rubbing * Math.abs(s - this.s)
      this.keptEvaluations = this.evaluations
      const { log } = this
      if (log) {
        const row = log.end - this.left
        log.s[row] = s
        log.v[row] = v
        log.heat[row] = this.heat
      }
      this.left--
    }
    this.s = s
    this.v = v
    this.known = this.reusable
    return this.left > 0
  }

  /** Ends a row at a step that was not kept: takes back what that has counted. */
  refuse(): void {
    this.inRow = false
    if (this.unsolvedAt === this.evaluations) this.unsolved--
    this.unsolvedAt = -1
    this.evaluations = this.keptEvaluations
  }

  /** Counts a step whose equation was not solved to rounding. */
  leaveUnsolved(): void {
    this.unsolved++
    this.unsolvedAt = this.evaluations
  }

  /** Finds out whether the next step can be one of a row, or needs a stopping rule. */
  startRow(): void {
    const { s, v, from, to, law } = this
    this.keptEvaluations = this.evaluations
    // Beyond these it has turned, or lost its stability.
    this.slowest = v > 0 ? 0 : -law.speedLimit
    this.fastest = v > 0 ? law.speedLimit : 0
    this.inRow =
      this.slipHeld &&
      this.dt > 0 &&
      v !== 0 &&
      (this.slip > 0 ? s >= from && s < to : s > from && s <= to)
  }

  /** Sets `drive` and `press` to what they are at the present `s` and `v`. */
  feel(): void {
    const { contact, forces } = this
    contact.s = this.s
    contact.v = this.v
    forces(contact)
    this.drive = contact.drive
    this.press = contact.press
  }

  /** Adds the heat of the step from the beginning noted to the present state: friction force × sliding distance. */
  addHeat(): void {
    if (this.pressChanges) Motion.addPressed(this)
    else this.heat += this.rubbing * Math.abs(this.s - this.startS)
  }

  /** Moves on to the end of a step of a row, and adds the heat where the normal force changes along it. */
  private static rubAlong(motion: Motion): void {
    motion.startS = motion.s
    motion.startV = motion.v
    motion.s = motion.endS
    motion.v = motion.endV
    Motion.addPressed(motion)
  }

  /**
   * The same where the normal force changes along the step: its mean over both ends times the distance, of the second
   * order; for a method of a higher one Simpson's rule over the cubic through both ends, so that its heat is as accurate
   * as its motion.
   */
  private static addPressed(motion: Motion): void {
    const { contact, forces, s, v, startS, startV, dt } = motion
    const distance = s - startS
    const before = motion.pressed
    let middle = 0
    if (motion.accurate && dt > 0) {
      const ends = (startV + v) / 4
      const speed = (1.5 * distance) / dt - ends
      // A diverging step's cubic may race between its ends; a real one's does not.
      const most = 2 * Math.max(Math.abs(startV), Math.abs(v))
      contact.s = 0.5 * (startS + s) + 0.125 * dt * (startV - v)
      contact.v = Math.max(-most, Math.min(most, speed))
      forces(contact)
      middle = contact.press * speed
    }
    contact.s = s
    contact.v = v
    forces(contact)
    motion.pressed = contact.press
    const work = motion.accurate
      ? ((before * startV + 4 * middle + contact.press * v) * dt) / 6
      : 0.5 * (before + contact.press) * distance
    motion.heat += motion.law.mass * motion.muKinetic * Math.abs(work)
  }

  /** Whether friction keeps to `slip` or takes the sign of v at every evaluation. */
  holdSlip(held: boolean): void {
    const { law } = this
    this.slipHeld = held
    this.reusable = !law.dependsOnSpeed && (held || law.muKinetic === 0)
    this.enterPiece()
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
    this.takeUpLaw()
    return !open || (piece > 0 && piece < joints.length)
  }

  /** Works out what is the same all along the piece, with friction to the present side. */
  private takeUpLaw(): void {
    const { law, slip, muKinetic } = this
    const given = law.forces[this.piece]!
    this.forces = this.asked[this.piece]!
    this.feel()
    this.pressChanges = typeof given === 'function' && muKinetic > 0
    this.rubbing = muKinetic === 0 ? 0 : law.mass * muKinetic * this.press
    this.pressed = this.press
    const plain = typeof given !== 'function' && this.slipHeld ? given : undefined
    const { drive = 0, perMetre = 0, perSquare = 0, press = 0 } = plain ?? {}
    this.isSteady = plain !== undefined && perMetre === 0 && perSquare === 0
    this.hasSpring = perMetre > 0 && perSquare === 0
    this.hasDrag = perSquare > 0 && perMetre === 0 && muKinetic === 0
    this.evenDrive = drive
    this.perMetre = perMetre
    this.perSquare = perSquare
    this.friction = slip * muKinetic * press
    this.steady = drive - this.friction
    this.low = Math.max(this.from, -FAR)
    this.high = Math.min(this.to, FAR)
  }

  /** Ends the motion: nothing that is left of the step, and no later one, changes it. */
  end(outcome: 'at-rest' | 'left-the-track' | 'diverged'): void {
    this.moving = false
    this.outcome = outcome
  }
}
