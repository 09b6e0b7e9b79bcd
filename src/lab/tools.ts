import { html } from 'lit'
import { iconButton } from '../ui/icons.ts'
import { allowed } from './labView.ts'
import type { LabView, Options } from './labView.ts'

/** What concerns the lab as a whole: going back, named experiments, taking it elsewhere. */
export function tools(lab: LabView) {
  const { history } = lab
  return html`<div class="tools" role="group" aria-label="Lab">
    ${button('undo', 'Undo (Ctrl+Z)', history.canUndo, () => history.undo())}
    ${button('redo', 'Redo (Ctrl+Shift+Z)', history.canRedo, () => history.redo())}
    ${allowed(lab, 'presets', presetMenus(lab))}
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

/** The menus of presets and of engines, whose presets suit what is on the ramp. */
function presetMenus(lab: LabView) {
  const { simulated, selected, preset, load } = lab
  const { presets, presetOptions, engines, engineOptions } = lab.menus
  // It is named for as long as nothing of it is changed.
  const shown = preset?.shown.state === simulated.state ? preset : undefined
  return [
    menu('Presets', presetOptions, presets.indexOf(shown!), (index) => load(presets[index]!)),
    menu(
      'Your engine',
      engineOptions,
      engines.findIndex(({ label }) => label === shown?.label),
      (index) => load(engines[index]!.presetOf(simulated.state, selected)),
    ),
  ]
}

/** A menu that reads its name while nothing of it is chosen. */
function menu(
  name: string,
  options: Options | undefined,
  chosen: number,
  choose: (index: number) => void,
) {
  return html`<select
    class="presets"
    aria-label=${name}
    ?data-empty=${!options}
    @change=${(event: Event) => {
      const select = event.target as HTMLSelectElement
      const index = Number(select.value)
      // It names what the lab shows, which may refuse a choice.
      select.value = String(chosen)
      choose(index)
    }}
  >
    <option value="-1" disabled .selected=${chosen < 0}>${name}</option>
    ${options?.(chosen)}
  </select>`
}
