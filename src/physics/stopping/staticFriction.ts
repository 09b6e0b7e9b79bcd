import type { Motion } from '../motion.ts'

/**
 * Decides for a block with v = 0 whether it stays. It does while |drive| ≤ μs press; otherwise its slip direction
 * becomes that of the drive, and true is returned.
 */
export function setsOff(motion: Motion): boolean {
  const { law } = motion
  motion.slip = 0
  motion.known = false
  motion.acceleration(motion.s, 0)
  if (Math.abs(motion.drive) <= law.muStatic * motion.press) {
    motion.outcome = 'at-rest'
    return false
  }
  motion.slip = motion.drive > 0 ? 1 : -1
  return true
}
