import { html } from 'lit'
import { forceDrawing } from '../view/forces.ts'
import { allowed } from '../lab/labView.ts'
import { Glide } from '../lab/glide.ts'
import type { OpenPanels } from '../lab/labView.ts'
import { atNow } from '../lab/playback/atNow.ts'
import { presetNote, refusalNotice } from '../lab/notices.ts'
import { ForcesSwitch } from './forces/forcesPanel.ts'
import { stepInspector } from './inspector/stepInspector.ts'
import { menus } from './menus.ts'
import { parametersPanel } from './parameters/parametersPanel.ts'
import { runnersTable } from './runners/runnersTable.ts'
import './measures/labMeasures.ts'
import './plots/labPlots.ts'
import './record/openLog.ts'
import './record/recordFrames.ts'
import './share/shareMenu.ts'
import './strip/frameStrip.ts'

/** Of a whole lab: all that is set and read in it. */
export const instruments: OpenPanels = (lab) => {
  const forces = new ForcesSwitch(lab)
  return {
    glide: new Glide(lab),
    note: () => presetNote(lab),
    refusal: refusalNotice,
    menus,
    forces: () => forces.vectors(),
    forceDrawing,
    below() {
      const { simulated, playback, selected, lesson } = lab
      return html`${allowed(lab, 'forces', forces.panel())} ${parametersPanel(lab)}
        ${runnersTable(lab)}
        <slide-lab-plots
          part="plots"
          .simulated=${simulated}
          .time=${atNow(playback, (time) => time)}
          .playback=${playback}
          .selected=${selected}
          .withoutExact=${lesson?.hides('exact') === true}
          .seek=${(time: number) => playback.seek(time)}
        ></slide-lab-plots>
        ${allowed(
          lab,
          'measures',
          html`<slide-lab-measures
            .simulated=${simulated}
            .selected=${selected}
            .lab=${lab}
          ></slide-lab-measures>`,
        )}
        ${allowed(lab, 'step', stepInspector(lab))}`
    },
  }
}
