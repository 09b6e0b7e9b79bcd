import { html, LitElement, nothing } from 'lit'
import type { PropertyValues } from 'lit'
import { live } from 'lit/directives/live.js'
import type { NumberOption } from '../physics/index.ts'
import { shownNumber, writeNumber } from '../chart/numbers.ts'
import { asTyped, isAmbiguous, readTyped } from '../chart/typedNumber.ts'
import { freshId } from './input.ts'
import { icon } from './icons.ts'
import { placeOf, stepped, valueAt } from './sliderScale.ts'

/** What a control needs to know of the number that it sets. */
export type Quantity = Pick<
  NumberOption,
  'label' | 'symbol' | 'unit' | 'min' | 'max' | 'atMax' | 'slider' | 'integer'
>

/**
 * A number that can be typed, stepped with ↑ and ↓ and, where there is room, slid.
 *
 * - `quantity`: its label, unit, range
 * - `value`: the number as it stands
 * - `initial`: if given, a reset button appears where the value differs from it
 * - `layout`: `full` (the default), `inline` for label and field and, where powers of ten are hard to type, the slider, `bare`
 *   for the field alone
 * - `labelled`: the owner of the number, for screen readers
 * - `pick`: called with the reader's input, a number or otherwise the text; returns what is wrong
 *   with it, or ''. Invalid input stays in the field, with that message under it
 */
class QuantityControl extends LitElement {
  static override properties = {
    quantity: { attribute: false },
    value: { attribute: false },
    initial: { attribute: false },
    layout: { reflect: true },
    labelled: {},
    draft: { state: true },
    problem: { state: true },
    typing: { state: true },
  }

  declare quantity: Quantity
  declare value: number
  declare initial: number | undefined
  declare layout: 'full' | 'inline' | 'bare'
  declare labelled: string | undefined
  /** Not reactive: a fresh closure is no reason to render again. */
  declare pick: (value: unknown) => string
  declare private draft: string | undefined
  declare private problem: string
  declare private typing: boolean
  private readonly inputId = freshId('quantity')

  constructor() {
    super()
    this.layout = 'full'
    this.problem = ''
    this.typing = false
  }

  override createRenderRoot(): this {
    return this
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('value')) this.settle()
  }

  override render() {
    const { quantity, layout, problem, labelled } = this
    const full = layout === 'full'
    const { label, symbol, unit } = quantity
    // As wide for the words as for the number, so that nothing moves when it gets the focus.
    const wide = Math.max(3, this.shown.length, quantity.atMax?.length ?? 0)
    return html`
      <label class=${layout === 'bare' ? 'visually-hidden' : 'quantity-label'} for=${this.inputId}>
        ${label}
        ${full ? html`<span class="symbol" aria-hidden="true">${typeset(symbol)}</span>` : nothing}
      </label>
      ${full ? this.slider() : nothing}
      <span class="field" data-unit=${unit} .style="--digits: ${wide}">
        <input
          id=${this.inputId}
          type="text"
          autocomplete="off"
          spellcheck="false"
          aria-label=${labelled ? `${label}, ${labelled}` : nothing}
          inputmode=${quantity.min < 0 ? 'text' : 'decimal'}
          title=${writeNumber(this.value)}
          aria-invalid=${problem !== ''}
          aria-describedby=${problem ? `${this.inputId}-problem` : nothing}
          .value=${live(this.shown)}
          @focus=${this.focused}
          @blur=${() => (this.typing = false)}
          @input=${(event: InputEvent) => (this.draft = (event.target as HTMLInputElement).value)}
          @change=${this.commit}
          @keydown=${this.pressed}
        />
        ${unit ? html`<span class="unit">${unit}</span>` : nothing}
      </span>
      ${full ? this.reset() : nothing}
      ${layout === 'inline' && quantity.slider.scale ? this.slider() : nothing}
      ${problem ? html`<p class="problem" id="${this.inputId}-problem" role="alert">${problem}</p>` : nothing}
    `
  }

  private get shown(): string {
    const { draft, typing, value, quantity } = this
    if (draft !== undefined) return draft
    if (quantity.slider.scale) return asTyped(value.toExponential())
    if (typing) return asTyped(writeNumber(value))
    return value === quantity.max && quantity.atMax ? quantity.atMax : asTyped(shownNumber(value))
  }

  private slider() {
    const { labelled } = this
    const { label, unit, slider } = this.quantity
    const [from, to, at] = [slider.from, slider.to, this.value].map((each) => placeOf(slider, each))
    const share = (at! - from!) / (to! - from!)
    return html`<input
      type="range"
      aria-label="${label}, slider${labelled ? `, ${labelled}` : ''}"
      aria-valuetext="${shownNumber(this.value)} ${unit}"
      min=${from!}
      max=${to!}
      step=${slider.step}
      .style="--filled: ${Math.min(1, Math.max(0, share))}"
      .value=${live(String(at))}
      @input=${(event: InputEvent) =>
        this.offer(valueAt(slider, (event.target as HTMLInputElement).valueAsNumber))}
    />`
  }

  private reset() {
    const { initial, value, quantity } = this
    const same = initial === undefined || initial === value
    return html`<button
      type="button"
      class="reset"
      ?hidden=${same}
      title="Back to ${initial === undefined ? '' : shownNumber(initial)} ${quantity.unit}"
      aria-label="Reset ${quantity.label}"
      @click=${() => this.restore(initial)}
    >
      ${icon('reset')}
    </button>`
  }

  private restore(initial: unknown): void {
    this.offer(initial)
    // The button disappears: move the focus first.
    this.querySelector<HTMLElement>('[type="range"]')!.focus()
  }

  private readonly focused = async (event: FocusEvent): Promise<void> => {
    // In a shadow root, an event has no target once it has been told.
    const field = event.target as HTMLInputElement
    this.typing = true
    await this.updateComplete
    field.select()
  }

  private readonly commit = (): void => {
    const { draft } = this
    if (draft === undefined) return
    if (draft.trim() === '') this.settle()
    else if (isAmbiguous(draft))
      this.problem = `“${draft.trim()}” may be a decimal or thousands: type a point, or no comma`
    else this.offer(readTyped(draft, this.quantity.unit) ?? draft)
  }

  private readonly pressed = (event: KeyboardEvent): void => {
    if (event.key === 'Escape' && this.draft !== undefined) {
      event.preventDefault()
      this.settle()
    }
    if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return
    event.preventDefault()
    const { min, max, slider } = this.quantity
    const steps = (event.key === 'ArrowUp' ? 1 : -1) * (event.shiftKey ? 10 : 1)
    const next = stepped(slider, this.value, steps)
    this.offer(Math.min(max, Math.max(min, next)))
  }

  private offer(value: unknown): void {
    this.problem = this.pick(value)
    if (this.problem === '') this.draft = undefined
    this.requestUpdate()
  }

  /** Shows the value as it stands. */
  private settle(): void {
    this.draft = undefined
    this.problem = ''
  }
}

customElements.define('slide-quantity-control', QuantityControl)

/** A quantity's symbol as it is set: the letter after a μ tells which μ it is. */
export function typeset(symbol: string) {
  return /^μ./.test(symbol) ? html`μ<sub>${symbol.slice(1)}</sub>` : symbol
}
