import type { Motion } from './motion.ts'

// What starts 1e9 m away and falls at 1e6 m/s² for 1e6 s does not get near it [m].
const FAR = 1e24

/** Ends a step that is accepted: adds the heat that friction made in it, and notices what no real motion comes to. */
export function settle(motion: Motion): void {
  if (!(Math.abs(motion.v) <= motion.speedLimit && Math.abs(motion.s) <= FAR)) {
    motion.end('diverged')
    // What a trajectory holds is always a number that can be drawn.
    if (!(Math.abs(motion.s) + Math.abs(motion.v) < Infinity)) motion.rewind()
    return
  }
  if (motion.rubs && motion.dt > 0) addHeat(motion)
}

/**
 * Friction force × sliding distance. Where the normal force changes along the step, Simpson's rule over the cubic
 * through both ends: of fourth order, so that the heat of an accurate method is as accurate as its motion.
 */
function addHeat(motion: Motion): void {
  if (motion.constantPress) {
    motion.heat += motion.rubbingMass * motion.press * Math.abs(motion.s - motion.startS)
    return
  }
  const { s, v, startS, startV, dt, a } = motion
  const distance = s - startS
  const ends = (startV + v) / 4
  motion.feel()
  let pressed = motion.press * v * dt
  motion.s = startS
  motion.v = startV
  motion.feel()
  pressed += motion.press * startV * dt
  motion.s = 0.5 * (startS + s) + 0.125 * dt * (startV - v)
  // A diverging step's cubic may race between its ends; a real one's does not.
  const most = 2 * Math.max(Math.abs(startV), Math.abs(v))
  motion.v = Math.max(-most, Math.min(most, (1.5 * distance) / dt - ends))
  motion.feel()
  pressed += motion.press * (6 * distance - 4 * ends * dt)
  motion.heat += (motion.rubbingMass * Math.abs(pressed)) / 6
  motion.s = s
  motion.v = v
  motion.a = a
}
