import type { NumberOption } from '../options.ts'

export const step = {
  type: 'number',
  label: 'Step',
  symbol: 'Δt',
  unit: 's',
  min: 1e-7,
  max: 60,
  slider: { from: 0.001, to: 0.1, step: 0.001 },
  initial: 1 / 60,
} as const satisfies NumberOption
