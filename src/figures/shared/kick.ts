import type { Experiment } from '../../physics/index.ts'

/** The kick up a slope that the figures on frames have in common, moved by the paper's step with its stops clamped. */
export const kick = {
  scene: 'ramp',
  parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  integrator: 'semi-implicit-euler',
  stopping: 'clamped',
} as const satisfies Experiment

/** How a frame's time becomes steps, in the words of the tutorial. */
export const policies = [
  { id: 'variable', label: 'variable' },
  { id: 'capped', label: 'capped' },
  { id: 'substeps', label: 'substeps' },
  { id: 'fixed', label: 'fixed' },
] as const

export type PolicyId = (typeof policies)[number]['id']
