import { ExactSum } from '../exactSum.ts'
import type { Values } from '../options.ts'
import { MOST_STEPS_A_FRAME, wholeSteps } from '../timestepPolicy.ts'
import type { TimestepPolicy } from '../timestepPolicy.ts'
import { step } from './options.ts'

const options = { step } as const

/** The frame in equal parts, none longer than the step. */
export const substeps = {
  id: 'substeps',
  label: 'Substeps',
  about:
    'Cuts each frame into equal parts no longer than a step: finer, but the parts still change with the frame.',
  options,
  losesTime: false,
  steps: ({ step }: Values<typeof options>, duration: number, frames: number) =>
    duration / step + frames,
  start: ({ step }: Values<typeof options>) => {
    const lost = new ExactSum()
    return (frame) => {
      const wanted = parts(frame.frameDuration, step)
      const count = Math.min(wanted, MOST_STEPS_A_FRAME)
      const length = frame.frameDuration / wanted
      frame.motion.dt = length
      frame.step(count)
      lost.add((wanted - count) * length)
      frame.lostTime = lost.value
      frame.stateTime = frame.time - frame.lostTime
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
