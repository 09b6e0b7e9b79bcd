import { figureNamed } from './figures.ts'
import type { LiveFigure } from './figures.ts'

/** So far a finger moves for one step of the number [px]. */
const STEP = 6

/**
 * Turns a number of the text into a field that drives a control of a figure: to type in, to step with the arrow keys, to
 * drag sideways. It follows the figure when that is changed elsewhere.
 */
export function dial(number: HTMLElement): void {
  const { figure: name, control, label, min, max, step } = number.dataset
  const figure = figureNamed(name!)
  const field = document.createElement('input')
  Object.assign(field, { type: 'number', min, max, step })
  field.value = number.textContent.replace('−', '-')
  field.setAttribute('aria-label', label!)
  const fit = () => field.style.setProperty('--digits', String(Math.max(1, field.value.length)))
  fit()
  number.replaceChildren(field)

  field.addEventListener('input', () => {
    fit()
    // What isn't a number yet, or is too large, is not what the reader means.
    if (field.value !== '' && field.validity.valid) drive(figure, control!, field.valueAsNumber)
  })
  field.addEventListener('change', (event) => {
    event.stopPropagation()
    show()
  })
  // Who scrolls the page means the page.
  field.addEventListener('wheel', () => field.blur(), { passive: true })
  const show = () => {
    const value = figure.values[control!]
    if (typeof value === 'number' && value !== field.valueAsNumber) field.value = String(value)
    fit()
  }
  figure.addEventListener('change', show)
  drag(field)
}

function drive(figure: LiveFigure, control: string, value: number): void {
  figure.set({ [control]: value })
}

/** Lets a field be dragged sideways like a slider. A press that does not move is a click into the field. */
function drag(field: HTMLInputElement): void {
  let from: { x: number; value: number } | undefined
  field.addEventListener('pointerdown', ({ button, clientX }) => {
    if (button === 0) from = { x: clientX, value: field.valueAsNumber }
  })
  field.addEventListener('pointermove', (event) => {
    if (!from || !(event.buttons & 1)) return
    const steps = Math.round((event.clientX - from.x) / STEP)
    if (!field.hasPointerCapture(event.pointerId)) {
      if (steps === 0) return
      field.setPointerCapture(event.pointerId)
      field.classList.add('dragged')
    }
    const [min, max, step] = [field.min, field.max, field.step].map(Number) as [
      number,
      number,
      number,
    ]
    const value = Math.min(max, Math.max(min, from.value + steps * step))
    // Rounded, so that 0.1 + 0.2 is 0.3.
    const text = String(Number(value.toPrecision(12)))
    if (text === field.value) return
    field.value = text
    field.dispatchEvent(new Event('input', { bubbles: true }))
  })
  field.addEventListener('lostpointercapture', () => field.classList.remove('dragged'))
  for (const type of ['pointerup', 'pointercancel'])
    field.addEventListener(type, () => (from = undefined))
}
