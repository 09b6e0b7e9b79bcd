import { steady } from './steady.ts'
import { jitter } from './jitter.ts'
import { hitch } from './hitch.ts'
import { missedVsync } from './missedVsync.ts'
import { recorded } from './recorded.ts'

/** Every frame clock, from the textbook's to the real one. */
export const frameClocks = [steady, jitter, hitch, missedVsync, recorded] as const

export type FrameClockId = (typeof frameClocks)[number]['id']
