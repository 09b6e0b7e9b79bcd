import { Lab } from '../lab/lab.ts'
import type { OpenPanels } from '../lab/labView.ts'
import { SlideStage } from '../lab/slideStage.ts'

/** The lab with the panels that it can open: they are loaded when its picture is there. */
export class SlideLab extends Lab {
  protected override async loadPanels(isCompact: boolean): Promise<OpenPanels> {
    return isCompact
      ? (await import('./compact.ts')).compact
      : (await import('./instruments.ts')).instruments
  }
}

/** Defines `<slide-lab>`, or what a page gives in its place, and what it shows first. The panels define themselves. */
export function defineLab(element: CustomElementConstructor = SlideLab): void {
  customElements.define('slide-stage', SlideStage)
  customElements.define('slide-lab', element)
}
