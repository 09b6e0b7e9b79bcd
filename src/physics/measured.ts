import { ExactSum } from './exactSum.ts'
import type { Frames } from './frameClock.ts'
import type { ChoiceOption, NumberOption, Values } from './options.ts'

const delta = {
  type: 'choice',
  label: 'Delta time',
  choices: ['exact', 'rounded', 'mean', 'snapped', 'late'],
  initial: 'exact',
  sparse: true,
} as const satisfies ChoiceOption

const meanOf = {
  type: 'number',
  label: 'Mean of',
  symbol: 'n',
  unit: 'frames',
  min: 1,
  max: 1000,
  integer: true,
  slider: { from: 1, to: 60, step: 1 },
  initial: 10,
  sparse: true,
} as const satisfies NumberOption

const snapTo = {
  type: 'number',
  label: 'Display',
  symbol: 'r',
  unit: 'Hz',
  min: 1,
  max: 10000,
  slider: { from: 30, to: 240, step: 1 },
  initial: 60,
  sparse: true,
} as const satisfies NumberOption

/** What every clock can be told besides: how the game measures its frames. */
export const measuring = { delta, meanOf, snapTo } as const

/** How the game measures its frames, as an experiment's `frames` say it. */
export type Measuring = Partial<Values<typeof measuring>>

/**
 * The frames as a game measures them: `duration` is the delta time that it moves by, and `time` the sum of those.
 * They are exact unless `delta` says otherwise:
 *
 * - `rounded`: to whole milliseconds
 * - `mean`: of the last `meanOf` frames, or of all as long as there are fewer
 * - `snapped`: to the nearest whole number of refreshes of a display at `snapTo` Hz, one at the least
 * - `late`: that of the frame before, since a game can't know how long the one will be that it is at; of the first, 0
 */
export function measure(
  { delta, meanOf: n = meanOf.initial, snapTo: rate = snapTo.initial }: Measuring,
  clock: Frames,
): Frames {
  if (!delta) return clock
  const sum = new ExactSum()
  // When the last frames ended, in a ring [s].
  const ends = new Float64Array(delta === 'late' ? 1 : n)
  let count = 0
  return {
    duration: NaN,
    time: 0,
    /** The clock is already at the frame that is to be measured. */
    next() {
      const { duration, time } = clock
      const slot = count++ % ends.length
      if (delta === 'rounded') this.duration = Math.round(1000 * duration) / 1000
      else if (delta === 'snapped') this.duration = Math.max(1, Math.round(duration * rate)) / rate
      else if (delta === 'late') this.duration = ends[0]! - this.time
      else this.duration = (time - ends[slot]!) / Math.min(count, ends.length)
      ends[slot] = time
      sum.add(this.duration)
      this.time = sum.value
    },
  }
}
