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

/** The menu of presets. It names the one that is shown for as long as nothing of it is changed. */
function presetMenu({ simulated, preset, load, presets }: LabView) {
  const isShown = preset?.shown.state === simulated.state
  return html`<select
    class="presets"
    aria-label="Preset"
    ?data-empty=${presets.length === 0}
    .value=${live(isShown ? String(presets.indexOf(preset)) : '-1')}
    @change=${(event: Event) => load(presets[Number((event.target as HTMLSelectElement).value)]!)}
  >
    <option value="-1" disabled selected>Presets</option>
    ${optionsOf(presets)}
  </select>`
}

/** The menu of engines. It names the one whose runners are shown. */
function engineMenu({ simulated, selected, preset, load, engines }: LabView) {
  const isShown = preset?.shown.state === simulated.state
  const picked = (event: Event) => {
    const { state } = simulated
    const choice = engines[Number((event.target as HTMLSelectElement).value)]!
    load(choice.presetOf(state, state.runners[selected]!.frames))
  }
  return html`<select
    class="presets engines"
    aria-label="Your engine"
    ?data-empty=${engines.length === 0}
    .value=${live(String(isShown ? engines.findIndex(({ label }) => label === preset.label) : -1))}
    @change=${picked}
  >
    <option value="-1" disabled selected>Your engine</option>
    ${engines.map(({ label }, i) => html`<option value=${i}>${label}</option>`)}
  </select>`
}

const options = new WeakMap<readonly Preset[], unknown>()

/** Made once: they are many, and never change. */
function optionsOf(presets: readonly Preset[]): unknown {
  const known = options.get(presets)
  if (known) return known
  const groups = [...new Set(presets.map(({ group }) => group))]
  const made = groups.map(
    (name) =>
      html`<optgroup label=${name}>
        ${presets.map(({ group, label }, i) =>
          group === name ? html`<option value=${i}>${label}</option>` : '',
        )}
      </optgroup>`,
  )
  options.set(presets, made)
  return made
}
