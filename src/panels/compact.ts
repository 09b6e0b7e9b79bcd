import { html, nothing } from 'lit'
import { Glide } from '../lab/glide.ts'
import type { OpenPanels } from '../lab/labView.ts'
import { site } from '../lab/site.ts'
import { linkTo, whyNoLink } from '../lab/state/address.ts'
import './share/shareMenu.ts'
import './strip/frameStrip.ts'

/** Of a lab that is a figure in somebody's page: the ways from there to the whole lab, and to its data. */
export const compact: OpenPanels = (lab) => ({
  glide: new Glide(lab),
  below: () => {
    if (lab.lesson?.may('share') === false) return nothing
    const home = site()
    return html`<div class="open-in-lab" part="link">
      <slide-share-menu .lab=${lab}></slide-share-menu>
      ${
        home === null || whyNoLink(lab.simulated.state)
          ? nothing
          : html`<a
              href=${linkTo('index.html', home, lab.simulated.state)}
              target="_blank"
              rel="noopener"
              >Open in the lab</a
            >`
      }
    </div>`
  },
})
