import type { Motion } from '../motion.ts'

/** After a whole step, finds the piece of track that the block has come to; beyond an open end it has left. */
export function stayOnTrack(motion: Motion): void {
  if (motion.outcome !== 'moving' || (motion.s > motion.from && motion.s < motion.to)) return
  motion.enterPiece()
  if (motion.isOff) {
    motion.outcome = 'left-the-track'
    motion.elapsed = motion.dt
  }
}
