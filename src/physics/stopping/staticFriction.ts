import type { Motion } from '../motion.ts'
import { enterPiece } from '../piece.ts'

/**
 * Decides for a block with v = 0 whether it stays: it does while |drive| ≤ μs press. Otherwise its slip direction becomes
 * that of the drive, and true is returned.
 */
// #region rest
export function setsOff(motion: Motion): boolean {
  const { law } = motion
  motion.slip = 0
  motion.feel()
  motion.evaluations++
  if (Math.abs(motion.drive) <= law.muStatic * motion.press) {
    motion.end('at-rest')
    return false
  }
  motion.slip = motion.drive > 0 ? 1 : -1
  // At a joint it sets off into the piece on that side.
  enterPiece(motion)
  return true
}
// #endregion
