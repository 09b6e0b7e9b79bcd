import '../../ui/defineMark.ts'
import { SpeedDiagram } from './speedDiagram.ts'

/* To be imported for the element alone, by the lab and by figures. */
customElements.define('speed-diagram', SpeedDiagram)
