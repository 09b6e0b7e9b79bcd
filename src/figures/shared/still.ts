import { simulate } from '../../physics/index.ts'
import type { Palette } from '../../view/palette.ts'
import { initialValues } from './control.ts'
import { WIDE } from './figure.ts'
import type { Figure, View } from './figure.ts'

/** What a figure shows when it opens. */
export function openingView(figure: Figure): View {
  const values = initialValues(figure.controls)
  const runs = figure.experiments(values).map(simulate)
  return { values, runs, time: figure.opensAtStart ? 0 : (figure.duration?.(values) ?? 0) }
}

/** The height of a figure's pictures together at a width [px]. */
export function heightOf({ panels }: Pick<Figure, 'panels'>, width: number): number {
  return panels.reduce(
    (sum, { shape }) => sum + width * (width < WIDE ? shape.narrow : shape.wide),
    0,
  )
}

/** Draws a figure as it opens, all of its pictures one under the other, from the context's origin. */
export function drawStill(
  context: CanvasRenderingContext2D,
  figure: Figure,
  { width, palette }: { width: number; palette: Palette },
): void {
  const view = openingView(figure)
  context.save()
  for (const panel of figure.panels) {
    const height = heightOf({ panels: [panel] }, width)
    context.save()
    panel.draw({ context, width, height, palette }, view)
    context.restore()
    context.translate(0, height)
  }
  context.restore()
}
