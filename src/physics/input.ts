import { wholeSteps } from './timestepPolicy.ts'

/** What becomes of a press that is read once a frame and used in fixed ticks. */
export interface Press {
  /** When the key goes down [s]. */
  readonly time: number
  /** The frame that reads it, the first that ends at that time or later; −1 while there is none. */
  readonly frame: number
  /** The ticks in which “pressed in this frame” is true, counted from 1: none, one or several. */
  readonly counted: readonly number[]
  /**
   * The tick that takes it where it is kept until one does, and the frame of that tick; 0 and −1 while there is none.
   */
  readonly kept: number
  readonly keptIn: number
}

/**
 * Runs frames that read presses and take fixed ticks, and gives each press to the ticks in both ways: as long as its
 * frame lasts, and until a tick takes it.
 *
 * @param ends when each frame ends [s]
 * @param step the length of a tick [s]
 * @param times when the key goes down [s], in any order
 */
export function readPresses(
  ends: readonly number[],
  step: number,
  times: readonly number[],
): readonly Press[] {
  const all = [...times]
    .sort((a, b) => a - b)
    .map((time) => ({ time, frame: -1, counted: [] as number[], kept: 0, keptIn: -1 }))
  const waiting: typeof all = []
  let ticks = 0
  let read = 0
  ends.forEach((end, frame) => {
    const pressed: typeof all = []
    while (read < all.length && all[read]!.time <= end) pressed.push(all[read++]!)
    for (const each of pressed) each.frame = frame
    // #region kept
    waiting.push(...pressed)
    while (ticks < wholeSteps(end, step)) {
      ticks++
      // What goes wrong: each tick of the frame asks what was pressed in the frame.
      for (const press of pressed) press.counted.push(ticks)
      // What goes right: it takes the oldest press that no tick has had.
      const press = waiting.shift()
      if (press) Object.assign(press, { kept: ticks, keptIn: frame })
    }
    // #endregion
  })
  return all
}
