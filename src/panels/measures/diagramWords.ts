import { integrators } from '../../physics/index.ts'
import { cheapest } from '../../measure/index.ts'
import { decadeText, roughSize } from '../../chart/magnitudes.ts'
import { plain } from '../../chart/numbers.ts'
import type { CostKind, DiagramCurve, DiagramPoint } from './points.ts'

/** Errors that people ask for, as powers of ten of a metre, and the last: none but rounding. */
const wanted = [-1, -2, -3, -6, -9]

/** What to use for an error. */
export interface Advice {
  readonly error: string
  readonly point: DiagramPoint
}

/** The frontier in words: the cheapest way to each error that people would ask for, each way named once. */
export function advice(curves: readonly DiagramCurve[]): Advice[] {
  const offers = curves.flatMap(({ points }) => points.filter(({ whole }) => whole))
  const found: Advice[] = []
  const add = (error: string, tolerance: number) => {
    const point = cheapest(offers, tolerance)
    if (!point) return
    // What is good for less is good for more.
    if (found.at(-1)?.point === point) found.pop()
    found.push({ error, point })
  }
  for (const exponent of wanted) add(decadeText(exponent), 10 ** exponent)
  add('no error but rounding', 0)
  return found
}

/** The error below which no point of the diagram comes, if that is more than rounding. */
export function leastError(curves: readonly DiagramCurve[]): number {
  const errors = curves.flatMap(({ points }) => points.filter(({ whole }) => whole))
  return Math.min(...errors.map(({ error }) => error))
}

/** Whose run a point is: “Velocity Verlet at 30 steps a second”, “30 fps in the lab”. */
export function pointName({ method, rate, runner }: DiagramPoint): string {
  const { label } = integrators.find(({ id }) => id === method)!
  return runner
    ? `${runner.name} in the lab, ${label}`
    : `${label} at ${plain(rate)} steps a second`
}

/** A point's error, or why it has none, in very few words. */
export function errorText({ error, outcome, whole }: DiagramPoint): string {
  if (whole) return roughSize(error)
  return outcome === 'diverged'
    ? 'blew up'
    : outcome === 'left-the-track'
      ? 'left the track'
      : 'not known'
}

/** What a point says, in a sentence. */
export function pointWords(
  { error, cost, mostCost, outcome, whole }: DiagramPoint,
  kind: CostKind,
): string {
  const price = `for ${kind.inWords(cost, mostCost)}`
  if (outcome === 'left-the-track') return `left the track, ${price}`
  if (outcome === 'diverged') return `blew up, ${price}`
  if (!whole) return 'the true motion is not known here'
  const size = error === 0 ? 'exact to rounding' : `never off by more than ${roughSize(error)}`
  return `${size}, ${price}`
}
