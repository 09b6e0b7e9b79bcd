import type { Work } from '../timing/rounds.ts'
import type { Amount } from '../works.ts'
import type { Block } from './block.ts'

/** Loops of so many frames of `step` seconds, `runs` of them at once. */
export function looping(start: () => Block, { runs, steps, step }: Amount): Work {
  const startAll = () => Array.from({ length: runs }, start)
  let blocks = startAll()
  return {
    units: runs * steps,
    prepare: () => {
      blocks = startAll()
    },
    run: () => {
      let sum = 0
      for (const block of blocks) {
        block.frames(steps, step)
        sum += block.s + block.v + block.heat
      }
      return sum
    },
  }
}
