import { html } from 'lit'
import { live } from 'lit/directives/live.js'
import { iconButton } from '../ui/icons.ts'
import { allowed } from './allowed.ts'
import type { LabView } from './labView.ts'
import type { Preset } from './presets/preset.ts'

/** What concerns the lab as a whole: going back, named experiments, taking it elsewhere. */
export function tools(lab: LabView) {
  const { history } = lab
  return html`<div class="tools" role="group" aria-label="Lab">
    ${button('undo', 'Undo (Ctrl+Z)', history.canUndo, () => history.undo())}
    ${button('redo', 'Redo (Ctrl+Shift+Z)', history.canRedo, () => history.redo())}
    ${allowed(lab, 'presets', [presetMenu(lab), engineMenu(lab)])}
    ${allowed(
      lab,
      'share',
      html`<slide-share-menu .lab=${lab}>
        <button type="button" class="toggle" aria-expanded="false">Share</button>
      </slide-share-menu>`,
    )}
  </div>`
}

function button(name: 'undo' | 'redo', label: string, isEnabled: boolean, act: () => void) {
  return iconButton(name, {
    label,
    act: (event) => {
      act()
      keepFocus(event.currentTarget as HTMLButtonElement)
    },
    className: 'step',
    isDisabled: !isEnabled,
  })
}

/** A button that was the last of its kind gives the focus to the other one. */
function keepFocus(button: HTMLButtonElement): void {
  const others = button.parentElement!.querySelectorAll<HTMLButtonElement>('.step')
  requestAnimationFrame(() => {
    if (button.disabled) [...others].find((other) => other !== button)!.focus()
  })
}

/** The preset that is shown, for as long as nothing of it is changed. */
function shown({ simulated, preset }: LabView): Preset | undefined {
  return preset?.shown.state === simulated.state ? preset : undefined
}

/** The menu of presets. It names the one that is shown. */
function presetMenu(lab: LabView) {
  const { presets, presetOptions } = lab.menus
  return html`<select
    class="presets"
    aria-label="Preset"
    ?data-empty=${presets.length === 0}
    .value=${live(String(presets.indexOf(shown(lab)!)))}
    @change=${(event: Event) => lab.load(presets[Number((event.target as HTMLSelectElement).value)]!)}
  >
    <option value="-1" disabled selected>Presets</option>
    ${presetOptions}
  </select>`
}

/** The menu of engines. It names the one whose runners are shown. */
function engineMenu(lab: LabView) {
  const { simulated, selected, menus, load } = lab
  const { engines, engineOptions } = menus
  const presetAt = (index: string) => engines[Number(index)]!.presetOf(simulated.state, selected)
  return html`<select
    class="presets"
    aria-label="Your engine"
    ?data-empty=${engines.length === 0}
    .value=${live(String(engines.findIndex(({ label }) => label === shown(lab)?.label)))}
    @change=${(event: Event) => load(presetAt((event.target as HTMLSelectElement).value))}
  >
    <option value="-1" disabled selected>Your engine</option>
    ${engineOptions}
  </select>`
}
