import type { Motion } from './motion.ts'
import type { MotionLog } from './motionLog.ts'

/**
 * Adds the heat of the step from the beginning noted to the present state: friction force × sliding distance. Where the
 * force and the acceleration are the same all along the piece, that follows from the distance when it is asked for.
 */
export function addHeat(motion: Motion): void {
  if (motion.rubs === 1) addChanging(motion)
  else motion.summed += motion.rubbing * Math.abs(motion.s - motion.startS)
}

/** Adds the heat of a step of a row that ends at `endS` and `endV`, and notes it in the log, which says how long the next is. */
export function endStep(motion: Motion): void {
  const { contact, law, log, endS, endV, taken } = motion
  motion.startS = motion.s
  motion.startV = motion.v
  motion.s = endS
  motion.v = endV
  addHeat(motion)
  if (motion.rubs === 1) {
    // The forces at the end have been felt for that: the next step begins with them.
    motion.feltS = endS
    motion.feltV = endV
    motion.feltA = contact.drive - motion.slip * law.muKinetic * contact.press
  }
  if (log === undefined) return
  log.heat[log.last + taken] = motion.summed
  motion.dt = log.lengths[taken]!
}

/** Notes the heat at the rows that a row of steps has just filled, where it follows from the distance. */
export function noteHeat(motion: Motion, log: MotionLog, count: number): void {
  const { kind, summed, evenRubbing, rubbedFrom } = motion
  if (kind !== 1) return
  const { last, s, heat } = log
  for (let row = last + 1; row <= last + count; row++)
    heat[row] = summed + evenRubbing * Math.abs(s[row]! - rubbedFrom)
}

/**
 * Where the normal force changes along the step: its mean over both ends times the distance, of the second order; for a
 * method of a higher one Simpson's rule over the cubic through both ends, of the fourth.
 */
function addChanging(motion: Motion): void {
  const { contact, forces, s, v, startS, startV, dt, law } = motion
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
  motion.summed += law.mass * law.muKinetic * Math.abs(work)
}
