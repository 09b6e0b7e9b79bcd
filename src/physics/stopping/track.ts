import type { Motion } from '../motion.ts'
import { enterPiece } from '../piece.ts'

/** After a whole step, finds the piece of track that the block has come to; beyond an open end it has left. */
export function stayOnTrack(motion: Motion): void {
  if (!motion.moving || (motion.s > motion.from && motion.s < motion.to)) return
  if (!enterPiece(motion)) motion.end('left-the-track')
}
