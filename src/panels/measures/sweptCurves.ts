import type { Experiment, StoppingId } from '../../physics/index.ts'
import { curvesOf, sweepMethods, sweepRates, sweepTolerances } from '../../measure/index.ts'
import type { Settings, SweepCurve, SweepRequest, TimedCurve } from '../../measure/index.ts'
import { diagramCurves } from './points.ts'
import type { CostKind, DiagramCurve } from './points.ts'
import { sharedExperiment } from './sharedExperiment.ts'
import type { Task } from './task.ts'

/** The curves of a sweep as far as they are measured, by method and kind. */
export class Curves<Curve extends Settings> extends Map<string, Curve> {
  /** What was asked for: the same for curves of the same request. */
  key = ''

  /** `fresh` says that these are the first of their request. */
  take(request: SweepRequest, curves: readonly Curve[], fresh: boolean): void {
    if (fresh) this.clear()
    this.key = JSON.stringify(request)
    for (const curve of curves) this.set(nameOf(curve), curve)
  }

  /** Whether they are those of a request. */
  areOf(request: SweepRequest): boolean {
    return this.key === JSON.stringify(request)
  }

  /** Whether there are all of a request. */
  areAllOf(request: SweepRequest): boolean {
    return this.areOf(request) && this.size === curvesOf(request).length
  }
}

/**
 * All methods at all rates and tolerances, in a scene and with a stopping rule.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function sweepRequest(experiment: Experiment, stopping: StoppingId): SweepRequest {
  return {
    experiment: { ...sharedExperiment(experiment), stopping },
    methods: sweepMethods,
    rates: sweepRates,
    tolerances: sweepTolerances,
  }
}

/** What of a request is to be measured next, so that its curves can be seen at such a cost. */
export function missing(
  request: SweepRequest,
  { id: cost }: CostKind,
  swept: Curves<SweepCurve>,
  timed: Curves<TimedCurve>,
): Task | undefined {
  if (request.experiment.duration === 0) return undefined
  if (!swept.areAllOf(request)) return { kind: 'sweep', request }
  if (cost === 'time' && !timed.areAllOf(request)) return { kind: 'timing', request }
  return undefined
}

/** The curves that can be seen at such a cost. */
export function curvesAt(
  { id: cost }: CostKind,
  swept: Curves<SweepCurve>,
  timed: Curves<TimedCurve>,
): DiagramCurve[] {
  const curves = [...swept.values()]
  if (cost === 'evaluations') return diagramCurves(curves, ({ evaluations }) => evaluations)
  const times = (curve: SweepCurve) =>
    timed.key === swept.key ? timed.get(nameOf(curve)) : undefined
  return diagramCurves(
    curves,
    (curve) => times(curve)?.nanoseconds,
    (curve) => times(curve)?.slowest,
  )
}

function nameOf({ method, by }: Settings): string {
  return `${method} by ${by}`
}
