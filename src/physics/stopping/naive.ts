import type { StoppingRule } from '../stoppingRule.ts'

/** The paper's formula as it stands: friction opposes the sign of v at each evaluation. */
export const naive = {
  id: 'naive',
  label: 'Naive',
  about:
    'Friction points against the velocity and that is all: around v = 0 it pushes to and fro for ever.',
  keepsOrder: false,
  holdsSlip: false,
  step: (motion, integrator) => {
    integrator.step(motion)
  },
} as const satisfies StoppingRule
