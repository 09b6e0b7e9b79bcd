import { stepToEvent } from '../events.ts'
import type { StoppingRule } from '../stoppingRule.ts'

/** Steps exactly up to the instant at which the law jumps; there it is decided how to go on with the rest of the step. */
export const located = {
  id: 'located',
  label: 'Located',
  about:
    'Finds the instant inside the step at which the block stops or meets a joint, and goes on from there: no trace of the frame rate is left.',
  keepsOrder: true,
  holdsSlip: true,
  step: stepToEvent,
} as const satisfies StoppingRule
