import type { NumberOption } from '../options.ts'

export const fps = {
  type: 'number',
  label: 'Frame rate',
  symbol: 'f',
  unit: 'fps',
  min: 1,
  // Ten times what the fastest displays show; a game without a cap draws some thousand frames a second.
  max: 10000,
  slider: { from: 5, to: 240, step: 1 },
  initial: 60,
} as const satisfies NumberOption

export const seed = {
  type: 'number',
  label: 'Seed',
  symbol: 'seed',
  unit: '',
  min: 0,
  max: 4294967295,
  integer: true,
  slider: { from: 1, to: 100, step: 1 },
  initial: 1,
} as const satisfies NumberOption
