import { SlideStage } from './slideStage.ts'

/** Defines what a lab is made of from the first moment. The rest defines itself when it is loaded. */
export function defineParts(): void {
  customElements.define('slide-stage', SlideStage)
}
