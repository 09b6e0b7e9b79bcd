import type { Motion } from './motion.ts'

/** What resists the motion at one end of a step, per mass, and its first three derivatives by the distance. */
class Resistance {
  /** [m/s²] */
  force = NaN
  first = NaN
  second = NaN
  third = NaN
}

const start = new Resistance()
const end = new Resistance()

/**
 * Adds the heat of the step from the beginning noted to the present state: the force of friction and drag times the
 * distance, and never what the energy has lost. Where the force is not the same all along, its integral comes from its
 * values and derivatives at both ends (Hermite's two-point formula), which is of the eighth order, as the best method is.
 */
export function addHeat(motion: Motion): void {
  const { startS, s, muKinetic, drag, curvature, law } = motion
  if (muKinetic === 0 && drag === 0) return
  const h = s - startS
  if (curvature === 0 && drag === 0) {
    motion.heat += law.mass * muKinetic * motion.weight * Math.abs(h)
    return
  }
  resistanceAt(motion, startS, motion.startV, start)
  resistanceAt(motion, s, motion.v, end)
  let work = 0.5 * (start.force + end.force)
  // On steps so long that the force has changed altogether, derivatives say nothing of what lies between.
  if (Math.abs(h) * (Math.abs(curvature) * (1 + 2 * muKinetic) + 2 * drag) < 1)
    work +=
      h *
      ((3 / 28) * (start.first - end.first) +
        h * ((1 / 84) * (start.second + end.second) + h * (1 / 1680) * (start.third - end.third)))
  motion.heat += law.mass * Math.abs(h * work)
}

/**
 * Sets what resists at a distance and a speed. With K = ½v², T = g sin θ and W = g cos θ (dT/ds = −κW, dW/ds = κT):
 *
 *     R = μk (W + 2κK) + 2(c/m)K,  dK/ds = T − (k/m)s − slip R
 *
 * so that each derivative of R follows from the one before.
 */
function resistanceAt(motion: Motion, s: number, v: number, at: Resistance): void {
  const { slip, muKinetic, drag, stiffness, curvature } = motion
  if (curvature !== 0) motion.turnTo(s)
  const { tangential, weight } = motion
  const perK = 2 * (muKinetic * curvature + drag)
  const bend = muKinetic * curvature
  at.force = muKinetic * weight + 0.5 * perK * v * v
  at.first = bend * tangential + perK * (tangential - stiffness * s - slip * at.force)
  at.second = -bend * curvature * weight - perK * (curvature * weight + stiffness + slip * at.first)
  at.third =
    -bend * curvature * curvature * tangential -
    perK * (curvature * curvature * tangential + slip * at.second)
}
