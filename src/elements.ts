import { defineParts } from './figure/defineParts.ts'
import { setSite } from './figure/site.ts'
import { SlideFigureElement } from './elements/figure.ts'
import { SlideLabElement } from './elements/lab.ts'

/**
 * The two elements for other people's pages, in one module: `<script type="module" src="…/slide-lab.js"></script>`.
 * Markup may come before or after it, and both may stand in shadow roots. What stands between their tags is seen only
 * where there are no scripts; what has `slot="caption"` is shown below.
 *
 * `<slide-lab>`: blocks on a track beside the exact one.
 * - attributes and properties `scene`, `fps`, `integrator`, `stopping`, `timestep`, `duration`, `experiment`: what it
 *   shows, see `Asked` in figure/attributes.ts. Wrong ones are told of above it, and it shows what it showed before
 * - attribute `compact`: only the buttons, the picture and the transport
 * - properties `experiments`: what is run now; `trajectories`: as `simulate` returned them; `playback`: its cursor on time
 * - event `change`, `detail.experiments`: whatever is run has become another, by the reader or by the page
 * - event `error`, `detail.message` and `detail.problems`: what was asked for can't be run
 *
 * `<slide-figure>`: a figure of the tutorial, alive when it comes near the window.
 * - attribute `name`: which one
 * - properties `values`, `trajectories`, `playback`, and `set(values)`, which changes what its controls say
 * - event `change`, `detail` are its values; event `error`, `detail.message`: there is no such figure
 *
 * Both:
 * - event `timeupdate`, `detail.time` [s]: the instant shown has moved
 * - attribute `data-theme`, `light` or `dark`: in the place of the system's setting
 * - CSS variables as in styles/theme.css: `--accent`, `--paper`, `--sheet`, `--ink`, `--line`, `--runner-0` … `--runner-7`,
 *   and `--font-text`, `--font-controls`
 *
 * None of the events bubbles but `change` of a figure.
 */
export { SlideFigureElement, SlideLabElement }
export { setSite }

// A page that has it twice, from two places, keeps the first.
if (!customElements.get('slide-lab')) {
  setSite(new URL(/* @vite-ignore */ './', import.meta.url).href)
  defineParts()
  customElements.define('slide-lab', SlideLabElement)
  customElements.define('slide-figure', SlideFigureElement)
}
