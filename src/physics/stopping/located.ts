import { stepToEvent } from '../events.ts'
import type { StoppingRule } from '../stoppingRule.ts'

/** Ends a step exactly where the law jumps. Static friction decides there, and the rest of the step follows. */
export const located = {
  id: 'located',
  label: 'Located',
  about:
    'Finds the instant inside the step at which the block stops or meets a joint, and goes on from there: no trace of the frame rate is left.',
  keepsOrder: true,
  holdsSlip: true,
  step: stepToEvent,
} as const satisfies StoppingRule
