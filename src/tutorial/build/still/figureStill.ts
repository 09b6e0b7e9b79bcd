import type { Figure } from '../../../figures/shared/figure.ts'
import { drawStill, heightOf } from '../../../figures/shared/still.ts'
import { attributes } from '../html.ts'
import { stillPalette } from './palette.ts'
import { svgOf } from './svgCanvas.ts'

/** How wide stills are drawn [px]: so that their letters can be read in a column as on paper. */
const WIDTH = 640

/** A figure as it opens: the same runs through the same drawing code as in the page, as SVG. */
export function figureStill(figure: Figure): string {
  const size = { width: WIDTH, height: Math.round(heightOf(figure, WIDTH)) }
  const svg = svgOf(figure.id, size, (context) =>
    drawStill(context, figure, { width: WIDTH, palette: stillPalette }),
  )
  const label = attributes({ 'aria-label': figure.pictured })
  return `<div class="still" role="img"${label}>${svg}</div>`
}
