import type { Motion } from '../motion.ts'

/**
 * Decides for a block with v = 0, `elapsed` seconds into the step, whether it stays: it does while |drive| ≤ μs press.
 * Otherwise its slip direction becomes that of the drive, and true is returned.
 */
export function setsOff(motion: Motion, elapsed: number): boolean {
  const { law } = motion
  motion.slip = 0
  motion.acceleration(motion.s, 0)
  if (Math.abs(motion.drive) <= law.muStatic * motion.press) {
    motion.end('at-rest', elapsed)
    return false
  }
  motion.slip = motion.drive > 0 ? 1 : -1
  // At a joint it sets off into the piece on that side.
  motion.enterPiece()
  return true
}
