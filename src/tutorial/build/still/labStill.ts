import { Simulation } from '../../../lab/state/simulation.ts'
import { opening } from '../../../lab/state/opening.ts'
import { describe } from '../../../lab/words.ts'
import { Stage } from '../../../view/stage.ts'
import { attributes } from '../html.ts'
import { svgOf } from './svgCanvas.ts'

const size = { width: 900, height: 380 }

/** The lab's picture as it opens, for the time before it is there, and for a page without JavaScript. */
export function labStill(): string {
  const simulated = new Simulation().run(opening)
  const { scene, exact, visible, state } = simulated
  const { parameters, duration } = state
  const runners = visible.map(({ trajectory, name, state: { look } }) => ({
    trajectory,
    name,
    look,
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
