import { ExactSum } from '../exactSum.ts'
import type { Values } from '../options.ts'
import { MOST_STEPS_A_FRAME, wholeSteps } from '../timestepPolicy.ts'
import type { TimestepPolicy } from '../timestepPolicy.ts'
import { maxSteps, step } from './options.ts'

const options = { step, maxSteps } as const

/** The frame in equal parts, none longer than the step; what exceeds the most steps of a frame is dropped. */
export const substeps = {
  id: 'substeps',
  label: 'Substeps',
  about:
    'Cuts each frame into equal parts no longer than a step: finer, but they still change with the frame.',
  options,
  losesTime: false,
  steps: (chosen: Values<typeof options>, duration: number, frames: number) =>
    Math.min(duration, longest(chosen) * frames) / chosen.step + frames,
  start: (chosen: Values<typeof options>) => {
    const { step } = chosen
    const longestFrame = longest(chosen)
    const lost = new ExactSum()
    return (frame) => {
      const time = Math.min(frame.frameDuration, longestFrame)
      const wanted = parts(time, step)
      const count = Math.min(wanted, MOST_STEPS_A_FRAME)
      const length = time / wanted
      frame.motion.dt = length
      frame.step(count)
      lost.add(frame.frameDuration - time)
      lost.add((wanted - count) * length)
      frame.lostTime = lost.value
      frame.stateTime = frame.gameTime - frame.lostTime
    }
  },
} as const satisfies TimestepPolicy

/** The longest frame that is not cut [s]: one of as many whole steps as a frame may take. */
function longest({ step, maxSteps }: Values<typeof options>): number {
  return maxSteps < MOST_STEPS_A_FRAME ? maxSteps * step : Number.MAX_VALUE
}

function parts(frameDuration: number, step: number): number {
  const whole = wholeSteps(frameDuration, step)
  // A remainder that is only rounding is no part of its own.
  return frameDuration - whole * step > 8 * Number.EPSILON * frameDuration || whole === 0
    ? whole + 1
    : whole
}
