import type { NumberOption } from '../options.ts'

/** The parameters that several scenes share, with their defaults. */

export const angle = {
  type: 'number',
  label: 'Angle',
  symbol: 'α',
  unit: '°',
  min: 0,
  max: 90,
  slider: { from: 0, to: 60, step: 0.5 },
  initial: 30,
  optional: true,
} as const satisfies NumberOption

export const muStatic = {
  type: 'number',
  label: 'Static friction',
  symbol: 'μs',
  unit: '',
  min: 0,
  max: 1e6,
  slider: { from: 0, to: 1.5, step: 0.01 },
  initial: 0.3,
  optional: true,
} as const satisfies NumberOption

export const muKinetic = {
  type: 'number',
  label: 'Kinetic friction',
  symbol: 'μk',
  unit: '',
  min: 0,
  max: 1e6,
  slider: { from: 0, to: 1.5, step: 0.01 },
  initial: 0.2,
  optional: true,
} as const satisfies NumberOption

export const gravity = {
  type: 'number',
  label: 'Gravity',
  symbol: 'g',
  unit: 'm/s²',
  min: 0,
  max: 1e6,
  slider: { from: 0, to: 25, step: 0.01 },
  initial: 9.81,
  optional: true,
} as const satisfies NumberOption

export const mass = {
  type: 'number',
  label: 'Mass',
  symbol: 'm',
  unit: 'kg',
  min: 1e-9,
  max: 1e9,
  slider: { from: 0.1, to: 20, step: 0.1 },
  initial: 1,
  optional: true,
} as const satisfies NumberOption

export const position = {
  type: 'number',
  label: 'Start',
  symbol: 's₀',
  unit: 'm',
  min: -1e9,
  max: 1e9,
  slider: { from: -5, to: 5, step: 0.05 },
  initial: 0,
  optional: true,
} as const satisfies NumberOption

export const speed = {
  type: 'number',
  label: 'Starting speed',
  symbol: 'v₀',
  unit: 'm/s',
  min: -1e9,
  max: 1e9,
  slider: { from: -12, to: 12, step: 0.1 },
  initial: 0,
  optional: true,
} as const satisfies NumberOption
