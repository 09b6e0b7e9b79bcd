import { attributes, escaped } from '../html.ts'
import type { Values } from '../html.ts'
import { applied } from './matrix.ts'
import { short } from './svgPath.ts'
import { precise } from './svgState.ts'
import type { SvgState } from './svgState.ts'

/** A text from a point on its baseline to the right, as src/view/text.ts writes all, in the state's font and matrix. */
export function textElement(
  state: SvgState,
  text: string,
  x: number,
  y: number,
  values: Values = {},
): string {
  const matrix = state.getTransform()
  const { a, b, c, d, e, f } = matrix
  const isPlain = a === 1 && b === 0 && c === 0 && d === 1
  const [left, top] = isPlain ? applied(matrix, x, y) : [x, y]
  const transform = isPlain ? undefined : `matrix(${[a, b, c, d, e, f].map(precise).join(' ')})`
  const place = { x: short(left), y: short(top), transform }
  const all = { ...place, ...values, style: `font:${state.font}` }
  return `<text${attributes(all)}>${escaped(text)}</text>`
}
