import type { ReactiveControllerHost } from 'lit'
import type { Picture } from '../view/picture.ts'
import { forcesPanel } from './forcesPanel.ts'
import { pictureForces } from './forcesPicture.ts'
import type { LabView } from './labView.ts'

/** Whether a lab shows forces: not at first. It is remembered as long as the page is. */
export class ForcesSwitch {
  private shown = false

  constructor(private readonly lab: LabView & ReactiveControllerHost) {}

  /** What the picture shows of the selected runner. */
  picture(): Pick<Picture, 'selected' | 'forces'> {
    const { simulated, selected } = this.lab
    const index = simulated.visible.indexOf(simulated.runners[selected]!)
    return {
      selected: index < 0 ? undefined : index,
      forces: this.shown ? pictureForces(this.lab) : undefined,
    }
  }

  /** The switch, and the legend of the forces. */
  panel() {
    return forcesPanel(this.lab, this.shown, (shown) => {
      this.shown = shown
      this.lab.requestUpdate()
    })
  }
}
