import '../ui/defineMark.ts'
import { StepInspector } from './inspector/stepInspector.ts'
import { LabMeasures } from './measures/labMeasures.ts'
import { LabPlot } from './plots/labPlot.ts'
import { LabPlots } from './plots/labPlots.ts'
import { QuantityControl } from '../ui/quantityControl.ts'
import { RecordFrames } from './record/recordFrames.ts'
import { RunnerRow } from './runners/runnerRow.ts'
import { ShareMenu } from './share/shareMenu.ts'
import './strip/defineStrip.ts'

/* What a lab is made of besides its picture, each after those that it is made of itself. */
customElements.define('quantity-control', QuantityControl)
customElements.define('runner-row', RunnerRow)
customElements.define('lab-plot', LabPlot)
customElements.define('lab-plots', LabPlots)
customElements.define('lab-measures', LabMeasures)
customElements.define('step-inspector', StepInspector)
customElements.define('record-frames', RecordFrames)
customElements.define('share-menu', ShareMenu)
