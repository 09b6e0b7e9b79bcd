import { html } from 'lit'
import { icon } from '../ui/icons.ts'
import type { LabView } from './labView.ts'
import { presetMenu } from './presetMenu.ts'

/** What concerns the lab as a whole: going back, named experiments, taking it elsewhere. */
export function tools(lab: LabView) {
  const { past } = lab
  return html`<div class="tools" role="group" aria-label="Lab">
    ${button('undo', 'Undo (Ctrl+Z)', past.canUndo, () => past.undo())}
    ${button('redo', 'Redo (Ctrl+Shift+Z)', past.canRedo, () => past.redo())} ${presetMenu(lab)}
    <share-menu .lab=${lab}>
      <button type="button" class="toggle" aria-expanded="false">Share</button>
    </share-menu>
  </div>`
}

function button(name: 'undo' | 'redo', label: string, isEnabled: boolean, act: () => void) {
  return html`<button
    type="button"
    class="step"
    title=${label}
    aria-label=${label.replace(/ \(.*/, '')}
    ?disabled=${!isEnabled}
    @click=${(event: Event) => {
      act()
      keepFocus(event.currentTarget as HTMLButtonElement)
    }}
  >
    ${icon(name)}
  </button>`
}

/** A button that was the last of its kind gives the focus to the other one. */
function keepFocus(button: HTMLButtonElement): void {
  const others = button.parentElement!.querySelectorAll<HTMLButtonElement>('.step')
  requestAnimationFrame(() => {
    if (button.disabled) [...others].find((other) => other !== button)!.focus()
  })
}
