import { Stage } from '../../view/stage.ts'
import { opening } from '../../lab/state/opening.ts'
import { Simulation } from '../../lab/state/simulation.ts'
import { describe } from '../../lab/words.ts'
import type { Figure } from '../../figures/shared/figure.ts'
import { drawStill, heightOf } from '../../figures/shared/still.ts'
import { attributes } from './html.ts'
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

const size = { width: 900, height: 380 }

/** The lab's picture as it opens, for the time before it is there, and for a page without JavaScript. */
export function labStill(): string {
  const simulated = new Simulation().run(opening)
  const { scene, exact, visible, state } = simulated
  const { parameters, duration } = state
  const runners = visible.map(({ trajectory, name, state: { paletteIndex } }) => ({
    trajectory,
    name,
    paletteIndex,
  }))
  const svg = svgOf('lab', size, (context) => {
    const canvas = { clientWidth: size.width, clientHeight: size.height, getContext: () => context }
    new Stage(canvas as unknown as HTMLCanvasElement).draw({
      ...{ scene, parameters, duration, runners, exact },
      time: duration,
    })
  })
  const label = attributes({ 'aria-label': describe(simulated, duration) })
  return `<div class="still" role="img"${label}>${svg}</div>`
}
