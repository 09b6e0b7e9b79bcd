import type { Motion } from './motion.ts'
import type { Resistance } from './resistance.ts'

/**
 * Adds the heat, and a belt's work, of the step from its recorded start to the present state: friction and drag times
 * distance, never the loss of energy. On a bend and in air the integral comes from the force and its derivatives at
 * both ends (Hermite's two-point formula), of eighth order like the best method.
 */
export function addHeat(motion: Motion): void {
  const { startS, startV, s, v, curvature, law } = motion
  const { mass, muKinetic, drag } = law
  if (muKinetic === 0 && drag === 0) return
  const h = s - startS
  if (curvature === 0 && drag === 0) {
    const force = mass * muKinetic * motion.weight
    const carried = law.belt * motion.dt
    motion.heat += force * Math.abs(h - carried)
    motion.work -= motion.slip * force * carried
    return
  }
  const start = motion.resistance
  const end = start.other!
  if (start.s !== startS || start.v !== startV) {
    start.s = startS
    start.v = startV
    resist(motion, start)
  }
  end.s = s
  end.v = v
  resist(motion, end)
  let mean = 0.5 * (start.force + end.force)
  // On steps so long that the force changes completely, the derivatives at the ends say nothing about the middle.
  if (Math.abs(h) * (Math.abs(curvature) * (1 + 2 * muKinetic) + 2 * drag) < 1)
    mean +=
      h * (3 / 28) * (start.first - end.first) +
      h * h * ((1 / 84) * (start.second + end.second) + h * (1 / 1680) * (start.third - end.third))
  motion.heat += mass * Math.abs(h * mean)
  // This step's end is the next one's start.
  motion.resistance = end
}

/**
 * Sets friction and drag, R, at a distance and a speed. With K = ½v², T = g sin θ and W = g cos θ (dT/ds = −κW, dW/ds = κT):
 *
 *     R = μk (W + 2κK) + 2(c/m)K,  dK/ds = T − (k/m)s − slip R
 *
 * so that each derivative of R follows from the one before.
 */
function resist(motion: Motion, at: Resistance): void {
  const { slip, curvature, law } = motion
  const { muKinetic, drag, stiffness } = law
  if (curvature !== 0) {
    motion.atS = at.s
    motion.turn()
  }
  const { tangential, weight } = motion
  const bend = muKinetic * curvature
  const perK = 2 * (bend + drag)
  const square = curvature * curvature
  at.force = muKinetic * weight + 0.5 * perK * at.v * at.v
  at.first = bend * tangential + perK * (tangential - stiffness * at.s - slip * at.force)
  at.second = -bend * curvature * weight - perK * (curvature * weight + stiffness + slip * at.first)
  at.third = -bend * square * tangential - perK * (square * tangential + slip * at.second)
}
