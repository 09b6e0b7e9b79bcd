/** What a run is worth: its errors, its order, its energy, its frame-rate spread, the step at which it blows up. */

export { presentationErrors, trajectoryErrors } from './error.ts'
export type { Errors } from './error.ts'
export { energyResidual, mechanicalEnergy } from './energy.ts'
export { fingerprint, fingerprintExperiments } from './fingerprint.ts'
export { hardCaseClaims } from './hardCases/claims.ts'
export { hardCases } from './hardCases/index.ts'
export type { HardCase } from './hardCases/index.ts'
export { fittedOrder } from './order.ts'
export { frameRateSpread, spreadOf } from './spread.ts'
export { stabilityLimit, staysBounded } from './stability.ts'
