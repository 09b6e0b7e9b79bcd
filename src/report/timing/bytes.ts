import type { TimedWork } from './rounds.ts'

const ROUNDS = 5

/** Below this a count is 0 [bytes]: no number takes so little. */
const NOTHING = 0.05

/**
 * Bytes of the JavaScript heap that a unit of a work takes. The least of five rounds, since the engine itself may use
 * memory at any time. Needs `node --expose-gc` and a young generation that holds a round without being collected.
 */
export function bytesOf(work: TimedWork): number {
  let least = Infinity
  let used = 0
  for (let round = 0; round < ROUNDS && least > NOTHING * work.units; round++) {
    work.prepare?.()
    globalThis.gc?.()
    const before = process.memoryUsage().heapUsed
    used += work.run()
    least = Math.min(least, Math.abs(process.memoryUsage().heapUsed - before))
  }
  if (Number.isNaN(used)) throw new Error('A work whose memory was measured came to no number.')
  return least / work.units
}
