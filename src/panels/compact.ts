import { html } from 'lit'
import { Glide } from '../lab/glide.ts'
import type { OpenPanels } from '../lab/labView.ts'
import { site } from '../lab/site.ts'
import { linkTo } from '../lab/state/address.ts'
import './strip/frameStrip.ts'

/** Of a lab that is a figure in somebody's page: the way from there to the whole lab. */
export const compact: OpenPanels = (lab) => ({
  glide: new Glide(lab),
  below: () =>
    html`<p class="open-in-lab" part="link">
      <a href=${linkTo('index.html', site(), lab.simulated.state)} target="_blank" rel="noopener"
        >Open in the lab</a
      >
    </p>`,
})
