/** Measures of a run: errors, order, energy, work, frame-rate spread, and the step at which it blows up. */

export { presentationErrors, presentationErrorSizes, trajectoryErrors } from './error.ts'
export type { Errors, ErrorSizes } from './error.ts'
export { energyResidual, mechanicalEnergy } from './energy.ts'
export { fingerprint, fingerprintExperiments } from './fingerprint.ts'
export { cheapest, frontier } from './frontier.ts'
export type { Offer } from './frontier.ts'
export { hardCases } from './hardCases/index.ts'
export type { HardCase } from './hardCases/index.ts'
export { fittedOrder } from './order.ts'
export {
  cellKinds,
  COARSE,
  coarseCell,
  mappedExperiment,
  rateAt,
  rateMap,
  REFERENCE_RATE,
  rowsOf,
  rowValue,
} from './rateMap.ts'
export type { CellKind, MapRequest, MapRow } from './rateMap.ts'
export { leastDifference, scaleOf, withoutRounding } from './rounding.ts'
export type { Scale } from './rounding.ts'
export { spreadOf } from './spread.ts'
export type { Spread } from './spread.ts'
export { frameRateSpread, paperMethod, spreadMethods, spreadTable } from './spreadTable.ts'
export type { Method, SpreadRequest, SpreadRow } from './spreadTable.ts'
export { stabilityLimit, staysBounded } from './stability.ts'
export { stableRate } from './stability.ts'
export {
  counts,
  curvesOf,
  isExact,
  orderOfCurve,
  outcomeKinds,
  sweep,
  sweepMethods,
  sweepRates,
  sweepTolerances,
  sweptExperiment,
  timedSweep,
  TIMED_ROUNDS,
  tolerantExperiment,
} from './sweep.ts'
export type { Settings, SweepCurve, SweepRequest, TimedCurve } from './sweep.ts'
export { evaluationsPerSecond, nanosecondsPerSecond, tickOf } from './work.ts'
export type { Clock } from './work.ts'
export { withParameters } from './withParameters.ts'
