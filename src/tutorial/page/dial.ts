import { shownNumber } from '../../chart/numbers.ts'
import { asTyped, readNumber, readTyped } from '../../chart/typedNumber.ts'
import { figureNamed } from './figures.ts'

/** So far a finger moves for one step of the number [px]. */
const STEP = 6

/**
 * Turns a number of the text into a field that drives a control of a figure: to type in, to step with the arrow keys, to
 * drag sideways. It follows the figure when that is changed elsewhere.
 */
export function dial(number: HTMLElement): void {
  const { figure: name, control, label } = number.dataset
  const [min, max, step] = ['min', 'max', 'step'].map((each) => Number(number.dataset[each]))
  const range: Range = { min: min!, max: max!, step: step! }
  const figure = figureNamed(name!)
  // One of type number writes a hyphen for a minus, and reads decimals as the browser’s language does.
  const field = document.createElement('input')
  Object.assign(field, { type: 'text', autocomplete: 'off', role: 'spinbutton' })
  field.inputMode = range.min < 0 ? 'text' : 'decimal'
  field.setAttribute('aria-label', label!)
  field.setAttribute('aria-valuemin', String(min))
  field.setAttribute('aria-valuemax', String(max))
  let value = readNumber(number.textContent)!
  const fit = () => field.style.setProperty('--digits', String(Math.max(1, field.value.length)))
  const show = (shown: number) => {
    value = shown
    field.value = asTyped(shownNumber(value))
    field.setAttribute('aria-valuenow', String(value))
    field.setAttribute('aria-invalid', 'false')
    fit()
  }
  show(value)
  number.replaceChildren(field)

  const drive = (next: number) => {
    show(next)
    figure.set({ [control!]: next })
  }
  const stepBy = (steps: number, from = value) => drive(within(range, from + steps * range.step))
  field.addEventListener('input', () => {
    fit()
    const typed = readTyped(field.value, '')
    // What isn't a number yet, or is too large, is not what the reader means.
    const isMeant = typed !== undefined && typed === within(range, typed)
    field.setAttribute('aria-invalid', String(!isMeant))
    if (!isMeant) return
    value = typed
    field.setAttribute('aria-valuenow', String(value))
    figure.set({ [control!]: value })
  })
  field.addEventListener('change', (event) => {
    event.stopPropagation()
    show(value)
  })
  field.addEventListener('keydown', (event) => {
    if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return
    event.preventDefault()
    stepBy(event.key === 'ArrowUp' ? 1 : -1)
  })
  figure.addEventListener('change', () => {
    const shown = figure.values[control!]
    if (typeof shown === 'number' && shown !== value) show(shown)
  })
  drag(field, () => value, stepBy)
}

interface Range {
  readonly min: number
  readonly max: number
  readonly step: number
}

/** The nearest value of a range; rounded, so that 0.1 + 0.2 is 0.3. */
function within({ min, max, step }: Range, value: number): number {
  const steps = Math.round((Math.min(max, Math.max(min, value)) - min) / step)
  return Number((min + steps * step).toPrecision(12))
}

/** Lets a field be dragged sideways like a slider. A press that does not move is a click into the field. */
function drag(
  field: HTMLInputElement,
  value: () => number,
  move: (steps: number, from: number) => void,
): void {
  let from: { x: number; value: number; steps: number } | undefined
  field.addEventListener('pointerdown', ({ button, clientX }) => {
    if (button === 0) from = { x: clientX, value: value(), steps: 0 }
  })
  field.addEventListener('pointermove', (event) => {
    if (!from || !(event.buttons & 1)) return
    const steps = Math.round((event.clientX - from.x) / STEP)
    if (steps === from.steps) return
    field.setPointerCapture(event.pointerId)
    field.classList.add('dragged')
    from.steps = steps
    move(steps, from.value)
  })
  field.addEventListener('lostpointercapture', () => field.classList.remove('dragged'))
  for (const type of ['pointerup', 'pointercancel'])
    field.addEventListener(type, () => (from = undefined))
}
