import { integrators } from '../../physics/index.ts'
import type { Integrator, IntegratorId, Outcome } from '../../physics/index.ts'
import {
  counts,
  isExact,
  orderOfCurve,
  outcomeKinds,
  withoutRounding,
} from '../../measure/index.ts'
import type { Settings, SweepCurve } from '../../measure/index.ts'
import { count, fixed, plain, seconds } from '../../chart/numbers.ts'

/** What a simulated second costs. */
export interface CostKind {
  readonly id: 'evaluations' | 'time'
  readonly label: string
  /** What the axis says. */
  readonly axis: string
  readonly about: string
  readonly text: (cost: number, most?: number) => string
  /** A cost in a sentence, with the most that it was in repeated measurements. */
  readonly inWords: (cost: number, most?: number) => string
}

/** In which costs are counted, the first by default. */
export const costKinds: readonly CostKind[] = [
  {
    id: 'evaluations',
    label: 'Evaluations',
    axis: 'evaluations for a simulated second',
    about: 'How often the forces are worked out: the same on every device.',
    text: (cost) => (cost >= 1 && cost < 1e6 ? count(Math.round(cost)) : plain(cost)),
    inWords: (cost) => `${plain(cost)} evaluations a second`,
  },
  {
    id: 'time',
    label: 'Time on this device',
    axis: 'time for a simulated second',
    about:
      'Measured here and now, in a program that has used every method: a game that keeps to one takes less.',
    text: timeText,
    inWords: (cost, most) => `${timeText(cost, most)} for a simulated second`,
  },
]

/** One run of a diagram: what it cost, and the error that this bought. */
export interface DiagramPoint {
  readonly method: IntegratorId
  readonly by: Settings['by']
  /** Steps a second, or the tolerance [m/s]. */
  readonly setting: number
  /** For a simulated second. */
  readonly cost: number
  /** The most that it was, where it was measured more than once. */
  readonly mostCost?: number | undefined
  /** The largest of the run, 0 where it is rounding [m]. */
  readonly error: number
  readonly outcome: Outcome['kind']
  /** Its error says something: it ran to its end, and the truth is known. */
  readonly whole: boolean
  /** The runner of the lab whose run it is, if it is one's. */
  readonly runner?: DiagramRunner
}

/** Whose run a point is. */
export interface DiagramRunner {
  readonly name: string
  /** Place in the palette and the list of marks. */
  readonly paletteIndex: number
  /** Its stopping rule or its time step is not that of the curves: it lies beside its method's. */
  readonly apart: boolean
}

/** What one method did. */
export interface DiagramCurve {
  readonly method: IntegratorId
  readonly by: Settings['by']
  readonly label: string
  /** Place in the palette and the list of marks. */
  readonly paletteIndex: number
  readonly points: readonly DiagramPoint[]
  /** What was found of its order, in a word or two; nothing of a curve by tolerance. */
  readonly order: string
  readonly exact: boolean
  /** The length of the path, against which rounding is measured [m]. */
  readonly scale: number
}

/** The curves of a diagram, from the sweep's numbers and what each point costs. */
export function diagramCurves(
  curves: readonly SweepCurve[],
  costs: (curve: SweepCurve) => Float64Array | undefined,
  mostCosts: (curve: SweepCurve) => Float64Array | undefined = () => undefined,
): DiagramCurve[] {
  return curves.flatMap((curve) => {
    const { label, colour }: Integrator = integrators.find(({ id }) => id === curve.method)!
    const cost = costs(curve)
    const most = mostCosts(curve)
    if (!cost) return []
    const { method, by, scale } = curve
    const points = curve.settings.map((setting, i) => ({
      ...{ method, by, setting },
      cost: cost[i]!,
      mostCost: most?.[i],
      error: withoutRounding(curve.errors[i]!, curve.scale),
      outcome: outcomeKinds[curve.outcomes[i]!]!,
      whole: counts(curve, i),
    }))
    const order = by === 'rate' ? orderText(curve) : ''
    const exact = isExact(curve)
    return [{ method, by, label, paletteIndex: colour, points, order, exact, scale }]
  })
}

/** Times [ns] with their spread: “1.2 µs to 1.4 µs”. */
function timeText(least: number, most = least): string {
  const [from, to] = [seconds(least * 1e-9), seconds(most * 1e-9)]
  return from === to ? from : `${from} to ${to}`
}

function orderText(curve: SweepCurve): string {
  if (isExact(curve)) return 'exact to rounding'
  const order = orderOfCurve(curve)
  if (Number.isFinite(order)) return `order ${fixed(order, 1)}`
  const whole = curve.settings.some((_, i) => counts(curve, i))
  return whole ? 'order not to be seen' : 'no run to its end'
}
