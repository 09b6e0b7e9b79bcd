import type { NumberOption } from '../options.ts'
import { MOST_STEPS_A_FRAME } from '../timestepPolicy.ts'

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

export const maxSteps = {
  type: 'number',
  label: 'Most steps a frame',
  symbol: 'n',
  unit: '',
  min: 1,
  max: MOST_STEPS_A_FRAME,
  atMax: 'no limit',
  integer: true,
  slider: { from: 1, to: 60, step: 1 },
  initial: MOST_STEPS_A_FRAME,
  optional: true,
} as const satisfies NumberOption

export const cap = {
  type: 'number',
  label: 'Cap',
  symbol: 'cap',
  unit: 's',
  min: 1e-6,
  max: 60,
  slider: { from: 0.01, to: 0.5, step: 0.01 },
  initial: 0.05,
} as const satisfies NumberOption
