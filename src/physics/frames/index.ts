import type { FrameClock } from '../frameClock.ts'
import { entry } from '../lists.ts'
import type { ChosenWhole } from '../options.ts'
import { steady } from './steady.ts'
import { jitter } from './jitter.ts'
import { hitch } from './hitch.ts'
import { missedVsync } from './missedVsync.ts'
import { recorded } from './recorded.ts'

/** Every frame clock, from the textbook's to the real one. */
export const frameClocks = [steady, jitter, hitch, missedVsync, recorded] as const

export type FrameClockId = (typeof frameClocks)[number]['id']

type Choices = {
  [Id in FrameClockId]: Extract<ChosenWhole<(typeof frameClocks)[number]>, { kind: Id }>
}
type Clocks = { [Id in FrameClockId]: FrameClock<Choices[Id]> }

/** The clock that an experiment names, with the options that it has there. */
export function clockOf<Id extends FrameClockId>(choice: Choices[Id]) {
  const clock = entry<Clocks[FrameClockId], Clocks[Id]>(frameClocks, choice.kind)
  return {
    start: () => clock.start(choice),
    frames: (duration: number) => clock.frames(choice, duration),
  }
}
