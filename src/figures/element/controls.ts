import { html, nothing } from 'lit'
import { live } from 'lit/directives/live.js'
import { plain } from '../../chart/numbers.ts'
import { typeset } from '../../ui/quantityControl.ts'
import type {
  ChoiceControl,
  Control,
  NumberControl,
  SwitchControl,
  Value,
  ControlValues,
} from '../shared/control.ts'
import type { Figure } from '../shared/figure.ts'

/** What controls are made from. */
interface Controlled {
  readonly figure: Figure
  readonly values: ControlValues
  readonly set: (values: Readonly<Record<string, unknown>>) => void
  readonly may: (control: string) => boolean
}

/** A figure's controls, the sliders first. */
export function controlsOf({ figure, values, set, may }: Controlled) {
  const shown = Object.entries(figure.controls).filter(([name, { hidden }]) => !hidden && may(name))
  if (shown.length === 0) return nothing
  const idle = figure.idle?.(values) ?? []
  return html`<div class="controls" part="controls">
    ${shown.map(([name, control]) =>
      oneOf(
        control,
        { id: `${figure.id}-${name}`, isIdle: idle.includes(name) },
        values[name]!,
        (value) => set({ [name]: value }),
      ),
    )}
  </div>`
}

type Pick = (value: Value) => void

/** What a control is called in the page, and whether it changes nothing at the moment. */
interface ControlState {
  readonly id: string
  readonly isIdle: boolean
}

function oneOf(control: Control, state: ControlState, value: Value, pick: Pick) {
  if (control.type === 'number') return slider(control, state, value as number, pick)
  if (control.type === 'choice')
    return (control.menu ? menuOf : choice)(control, state, value as string, pick)
  if (control.type === 'switch') return toggle(control, value as boolean, pick)
  return html`<slide-frames-recorder .pick=${pick}></slide-frames-recorder>`
}

/** A number as the controls write it: “30 fps”. */
export function quantityText({ unit = '' }: NumberControl, value: number): string {
  const gap = unit === '' || unit === '°' ? '' : '\u202f'
  return plain(value) + gap + unit
}

function slider(control: NumberControl, { id, isIdle }: ControlState, value: number, pick: Pick) {
  const { label, symbol, from, to, step } = control
  const text = quantityText(control, value)
  const widest = Math.max(quantityText(control, to).length, quantityText(control, to - step).length)
  return html`<div class="slider">
    <label for=${id}
      >${label} ${symbol ? html`<i aria-hidden="true">${typeset(symbol)}</i>` : nothing}</label
    >
    <input
      id=${id}
      ?disabled=${isIdle}
      type="range"
      min=${from}
      max=${to}
      step=${step}
      aria-valuetext=${text}
      .style="--filled: ${(value - from) / (to - from)}"
      .value=${live(String(value))}
      @input=${(event: Event) => pick((event.target as HTMLInputElement).valueAsNumber)}
    />
    <output for=${id} .style="min-width: ${widest}ch">${text}</output>
  </div>`
}

function choice(
  { label, options }: ChoiceControl,
  { id, isIdle }: ControlState,
  value: string,
  pick: Pick,
) {
  return html`<fieldset class="choice" ?disabled=${isIdle}>
    <legend><span>${label}</span></legend>
    <div class="options">
      ${options.map(
        (option) =>
          html`<label>
            <input
              type="radio"
              name=${id}
              .checked=${live(option.id === value)}
              @change=${() => pick(option.id)}
            />
            ${option.label}
          </label>`,
      )}
    </div>
  </fieldset>`
}

function menuOf(
  { label, options }: ChoiceControl,
  { id, isIdle }: ControlState,
  value: string,
  pick: Pick,
) {
  return html`<div class="choice">
    <label for=${id}>${label}</label>
    <select
      id=${id}
      ?disabled=${isIdle}
      .value=${live(value)}
      @change=${(event: Event) => pick((event.target as HTMLSelectElement).value)}
    >
      ${options.map(
        (option) =>
          html`<option value=${option.id} ?selected=${option.id === value}>
            ${option.label}
          </option>`,
      )}
    </select>
  </div>`
}

function toggle({ label, about }: SwitchControl, value: boolean, pick: Pick) {
  return html`<label class="toggle">
    <input
      type="checkbox"
      .checked=${live(value)}
      @change=${(event: Event) => pick((event.target as HTMLInputElement).checked)}
    />
    <span><b>${label}.</b> <small>${value ? about.on : about.off}</small></span>
  </label>`
}
