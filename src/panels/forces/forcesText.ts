import type { ResolvedExperiment } from '../../physics/index.ts'
import { fixed, plain } from '../../chart/numbers.ts'
import { length } from '../../physics/index.ts'
import type { Forces } from './forces.ts'

/** A figure with as many decimals as the largest of its kind makes worth reading, so that it keeps its width. */
export function quantity(value: number, largest: number): string {
  const size = Math.max(largest, Math.abs(value))
  if (!(size < 1e5) || (size > 0 && size < 0.01)) return plain(rounded(value, size))
  const decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 1 ? 2 : 4
  return fixed(value, decimals)
}

/** What is nothing beside the largest is nothing. */
function rounded(value: number, largest: number): number {
  return Math.abs(value) < 1e-9 * largest ? 0 : value
}

/** What friction does and why it is as large as it is; nothing where nothing can rub. */
export function frictionText(
  { parameters, stopping }: Pick<ResolvedExperiment, 'parameters' | 'stopping'>,
  { vectors }: Forces,
  largest: number,
): string {
  const { muStatic, muKinetic } = parameters
  if (muStatic === undefined || muKinetic === undefined) return ''
  const { friction, normal } = vectors
  const newtons = (value: number) => `${quantity(value, largest)}\u2009N`
  const size = newtons(length(friction))
  if (vectors.rubbing === 'held') {
    const most = Math.max(muStatic, muKinetic) * length(normal)
    return `Static friction holds it: ${size} of at most ${newtons(most)}.`
  }
  if (vectors.rubbing === 'none')
    return muStatic + muKinetic > 0
      ? 'No friction at v = 0: the naive rule knows only the friction of sliding.'
      : 'No friction: μ is 0.'
  const product = `μk N = ${plain(muKinetic)} × ${newtons(length(normal))}`
  const rule =
    stopping === 'naive' ? ' The naive rule knows no other, so nothing holds a block.' : ''
  return `Kinetic friction: ${product} = ${size}.${rule}`
}
