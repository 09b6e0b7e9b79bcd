import { ExactSum } from '../exactSum.ts'
import type { Values } from '../options.ts'
import { wholeSteps } from '../timestepPolicy.ts'
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
  steps: ({ step, maxSteps }: Values<typeof options>, duration: number, frames: number) =>
    Math.min(duration / step, maxSteps * frames) + frames,
  start: ({ step, maxSteps }: Values<typeof options>) => {
    const longest = maxSteps * step
    const lost = new ExactSum()
    return (frame) => {
      const time = Math.min(frame.frameDuration, longest)
      const count = parts(time, step)
      frame.motion.dt = time / count
      frame.step(count)
      lost.add(frame.frameDuration - time)
      frame.lostTime = lost.value
      frame.stateTime = frame.gameTime - frame.lostTime
    }
  },
} as const satisfies TimestepPolicy

function parts(frameDuration: number, step: number): number {
  const whole = wholeSteps(frameDuration, step)
  // A remainder that is only rounding is no part of its own.
  return frameDuration - whole * step > 8 * Number.EPSILON * frameDuration || whole === 0
    ? whole + 1
    : whole
}
