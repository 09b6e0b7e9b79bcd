import type { ReactiveControllerHost } from 'lit'
import type { PictureForces } from '../../view/picture.ts'
import { forcesPanel } from './forcesPanel.ts'
import { pictureForces } from './forcesPicture.ts'
import type { LabView } from '../../lab/labView.ts'

/** Whether a lab shows forces: not at first. It is remembered as long as the page is. */
export class ForcesSwitch {
  private shown = false

  constructor(private readonly lab: LabView & ReactiveControllerHost) {}

  /** Those of the selected runner, for the picture. */
  vectors(): PictureForces | undefined {
    return this.shown ? pictureForces(this.lab) : undefined
  }

  /** The switch, and the legend of the forces. */
  panel() {
    return forcesPanel(this.lab, this.shown, (shown) => {
      this.shown = shown
      this.lab.requestUpdate()
    })
  }
}
