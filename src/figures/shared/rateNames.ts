import type { Box } from '../../chart/geometry.ts'
import { write } from '../../chart/text.ts'
import type { DrawingSurface } from './figure.ts'

/** The frame rates of a graph's curves, in their colours: in its lower right corner, the first lowest. */
export function drawRateNames(
  { context, palette }: DrawingSurface,
  { right, bottom }: Box,
  rates: readonly number[],
): void {
  context.font = `500 12px ${palette.sans}`
  rates.forEach((fps, i) => {
    context.fillStyle = palette.runners[i]!.text
    write(context, `${fps} fps`, right - 10, bottom - 12 - 18 * i, {
      align: 'right',
      halo: palette.sheet,
    })
  })
}
