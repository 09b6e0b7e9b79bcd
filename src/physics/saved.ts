import type { Motion } from './motion.ts'

/** A snapshot of a motion, so that a step can be tried and taken back. */
export class Saved {
  private s = NaN
  private v = NaN
  private a = NaN
  private known = false
  private slip: Motion['slip'] = 0
  private outcome: Motion['outcome'] = 'moving'
  private heat = NaN
  private work = NaN
  private readonly motion: Motion

  constructor(motion: Motion) {
    this.motion = motion
  }

  save(): void {
    const { motion } = this
    this.s = motion.s
    this.v = motion.v
    this.a = motion.a
    this.known = motion.known
    this.slip = motion.slip
    this.outcome = motion.outcome
    this.heat = motion.heat
    this.work = motion.work
  }

  /** Restores the snapshot, but for the count of evaluations, which were made. */
  restore(): void {
    const { motion } = this
    motion.s = this.s
    motion.v = this.v
    motion.slide(this.slip)
    motion.enterPiece()
    motion.a = this.a
    motion.known = this.known
    motion.outcome = this.outcome
    motion.heat = this.heat
    motion.work = this.work
  }
}
