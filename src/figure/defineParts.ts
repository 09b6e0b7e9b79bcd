import { StepInspector } from './inspector/stepInspector.ts'
import { RecordFrames } from './recordFrames/recordFrames.ts'
import { LabMeasures } from './measures/labMeasures.ts'
import { FrameStrip } from './frameStrip.ts'
import { LabPlot } from './plots/labPlot.ts'
import { LabPlots } from './plots/labPlots.ts'
import { QuantityControl } from './quantityControl.ts'
import { RunnerMark } from './runnerMark.ts'
import { RunnerRow } from './runnerRow.ts'
import { ShareMenu } from './share/shareMenu.ts'
import { SlideStage } from './slideStage.ts'

/** Defines the elements that a lab is made of, each after those that it is made of itself. */
export function defineParts(): void {
  customElements.define('quantity-control', QuantityControl)
  customElements.define('frame-strip', FrameStrip)
  customElements.define('runner-mark', RunnerMark)
  customElements.define('runner-row', RunnerRow)
  customElements.define('slide-stage', SlideStage)
  customElements.define('lab-plot', LabPlot)
  customElements.define('lab-plots', LabPlots)
  customElements.define('lab-measures', LabMeasures)
  customElements.define('step-inspector', StepInspector)
  customElements.define('record-frames', RecordFrames)
  customElements.define('share-menu', ShareMenu)
}
