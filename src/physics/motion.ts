import { apart } from './apart.ts'
import { endStep } from './heat.ts'
import { Contact, feltOn } from './law.ts'
import type { Forces, Law } from './law.ts'
import type { MotionLog } from './motionLog.ts'
import { enterPiece } from './piece.ts'

/**
 * A block on a track, mid-step: the distance `s` along the track [m], the speed `v` = ds/dt [m/s], and what acts on
 * it. One mutable object with number fields, so that a step allocates nothing. The fields start as NaN, which makes
 * an engine store them as floating-point numbers from the first; what is asked in every step is a whole number rather
 * than true or false, since that costs an engine one comparison instead of five.
 *
 * The law is the same in every scene: dv/dt = drive − slip μk press (Coulomb friction).
 */
export class Motion {
  s = NaN
  v = NaN
  /** The acceleration that serves the next step too, where `known` [m/s²]. */
  a = NaN
  /** The length of the step to take [s]. */
  dt = NaN
  /** How far into the step asked for the motion has got [s]. */
  elapsed = NaN
  /** It has neither come to rest nor left the track nor diverged: there is something to step. */
  moving = true
  outcome: 'moving' | 'at-rest' | 'left-the-track' | 'diverged' = 'moving'
  /** How often the acceleration was evaluated. */
  evaluations = 0
  /** Implicit steps whose equation was not solved to rounding. */
  unsolved = 0

  /** The slip direction: the side to which friction does not point. Whoever changes it calls `enterPiece` after that. */
  slip: -1 | 0 | 1 = 0
  /** Friction keeps to `slip`, instead of taking the sign of each speed it is asked about. */
  slipHeld = true
  /** 1: `a` is the acceleration at the present state. */
  known: 0 | 1 = 0
  /** 1: the acceleration at a step's end serves the next step too, although v is corrected in between. */
  reusable: 0 | 1 = 0
  /** The method is of higher order than the second: the sum of the heat is, too. */
  accurate = false
  /** Every force along the track but friction, per mass, and the normal force per mass, as `feel` found them [m/s²]. */
  drive = NaN
  press = NaN
  /** How far before the jump that is looked for a tried step ended: negative past it. */
  miss = NaN

  // The steps of a row: how many are asked for (0 while they are tried one by one), how many have been taken, and up to
  // which one it is known beforehand that nothing happens.
  asked = 0
  taken = 0
  free = 0
  /** 1: all that the next step needs for one of a row is known. */
  inRow: 0 | 1 = 0
  /** Where the steps of a row are noted. */
  log: MotionLog | undefined
  /** 1: a step of the row ends with more than a sum of the heat. */
  atEnd: 0 | 1 = 0
  // A step of a row that ends between these has met no jump of the law.
  low = NaN
  high = NaN
  slowest = NaN
  fastest = NaN
  // What a step that is not kept has counted is taken back.
  keptEvaluations = 0
  unsolvedAt = -1

  /** The state at the beginning of the step, to which `rewind` returns. */
  startS = NaN
  startV = NaN
  startA = NaN
  startKnown: 0 | 1 = 0

  /** Where the piece of track whose law holds begins and ends [m]. */
  from = NaN
  to = NaN
  /** On that piece the acceleration is asked for (0), one number (1), or that and terms in s and v (2). */
  kind: 0 | 1 | 2 = 0
  forces: Forces
  steady = NaN
  perMetre = NaN
  perSquare = NaN
  friction = NaN
  askedS = NaN
  askedV = NaN
  answer = NaN

  // Heat: what has been added up, and what friction has made since it was at `rubbedFrom` where its force is always the same
  // and so is the acceleration [J, N, m]; the force in other steps [N], or 1 for `rubs` where it changes along the step.
  summed = NaN
  evenRubbing = NaN
  rubbedFrom = NaN
  rubbing = NaN
  rubs: 0 | 1 = 0
  /** The normal force per mass at the end of the last step, where it changes along the piece [m/s²]. */
  pressed = NaN
  /** The acceleration at the end of the last step, where the normal force has been felt there for the heat. */
  feltS = NaN
  feltV = NaN
  feltA = NaN
  endS = NaN
  endV = NaN

  // What is called apart from the integrators. Set twice, since a function that an engine knows to be always the same it would
  // compile in after all.
  private ask = endStep
  private note = accelerate

  readonly law: Law
  readonly contact = new Contact()
  readonly felt: readonly Forces[]

  constructor(law: Law, s: number, v: number) {
    this.law = law
    this.ask = accelerate
    this.note = endStep
    this.felt = law.forces.map(feltOn)
    this.forces = this.felt[0]!
    this.s = this.rubbedFrom = s
    this.v = v
    this.summed = this.evenRubbing = this.elapsed = 0
    this.slip = v > 0 ? 1 : v < 0 ? -1 : 0
    enterPiece(this)
  }

  /** Energy that friction has turned into heat [J]. */
  get heat(): number {
    return this.summed + this.evenRubbing * Math.abs(this.s - this.rubbedFrom)
  }

  /**
   * dv/dt at a distance and a speed of the present piece [m/s²]: what an integrator asks for. Short, so that an engine
   * compiles it into every integrator, and no number is boxed.
   */
  acceleration(s: number, v: number): number {
    const { kind, steady } = this
    if (kind === 1) return steady
    if (kind === 2)
      return steady - this.perMetre * s - this.perSquare * v * Math.abs(v) - this.friction
    this.askedS = s
    this.askedV = v
    apart(this.ask, this)
    return this.answer
  }

  /**
   * Ends a step at a distance and a speed: what an integrator calls, with how many steps that makes since it was called.
   * Returns whether it goes on from there with another. A step of those in a row that met a jump of the law is not kept:
   * the stopping rule takes it again.
   */
  goesOn(s: number, v: number, taken: number): boolean {
    const { log, asked } = this
    if (log !== undefined) {
      const row = log.last + taken
      log.s[row] = s
      log.v[row] = v
    }
    if (taken < this.free) return true
    if (asked > 0) {
      if (!(v > this.slowest && v < this.fastest && s > this.low && s < this.high)) return false
      this.taken = taken
      if (this.atEnd === 1) {
        this.endS = s
        this.endV = v
        apart(this.note, this)
      } else this.summed += this.rubbing * Math.abs(s - this.s)
    }
    this.s = s
    this.v = v
    return taken < asked
  }

  /** Counts a step whose equation was not solved to rounding. */
  leaveUnsolved(): void {
    this.unsolved++
    this.unsolvedAt = this.evaluations
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

  /** Ends the motion: nothing that is left of the step, and no later one, changes it. */
  end(outcome: 'at-rest' | 'left-the-track' | 'diverged'): void {
    this.moving = false
    this.outcome = outcome
  }
}

function accelerate(motion: Motion): void {
  const { contact, forces, law, askedS: s, askedV: v } = motion
  // Steps that are tried one by one are watched at times: each look is one of its own.
  if (motion.asked > 0 && s === motion.feltS && v === motion.feltV) {
    motion.answer = motion.feltA
    return
  }
  contact.s = s
  contact.v = v
  forces(contact)
  // #region accelerate
  const slip = motion.slipHeld ? motion.slip : v > 0 ? 1 : v < 0 ? -1 : 0
  motion.answer = contact.drive - slip * law.muKinetic * contact.press
  // #endregion
}
