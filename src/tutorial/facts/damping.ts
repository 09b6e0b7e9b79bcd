import { fixed, metres, plain } from '../../chart/numbers.ts'
import { decayRate, framesOfCoasting } from '../../physics/damping.ts'
import { percent } from './fact.ts'
import type { Facts } from './fact.ts'

const RATE = 5
const START = 5
const distance = (value: number) => metres(value)

/** How far a body gets that starts at 5 m/s with k = 5/s [m]: in 20 s it has come to rest to rounding. */
function coasted(fps: number): number {
  return framesOfCoasting('explicit', { k: RATE, v: START, fps, frames: 20 * fps }).at(-1)!
}

const tenths = (value: number) => `${fixed(100 * value, 1)}\u202f%`

/** What damping makes of the frame rate. */
export const damping = {
  coastTrue: { value: () => START / RATE, show: distance },
  coast30: { value: () => coasted(30), show: (value) => `${fixed(value, 4)}\u202fm` },
  coast60: { value: () => coasted(60), show: (value) => `${fixed(value, 4)}\u202fm` },
  coast200: { value: () => coasted(200), show: distance },
  kept30: { value: () => 0.99 ** 30, show: tenths },
  kept60: { value: () => 0.99 ** 60, show: tenths },
  rateOf099: { value: () => decayRate(0.99, 60), show: (value) => `${fixed(value, 3)}\u202f/s` },
  smoothing60: {
    value: () => decayRate(0.9, 60),
    show: (value) => `${plain(Number(value.toFixed(2)))}\u202f/s`,
  },
  smoothed30: { value: () => 1 - 0.9 ** 6, show: percent },
  smoothed120: { value: () => 1 - 0.9 ** 24, show: percent },
} as const satisfies Facts
