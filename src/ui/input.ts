/** Where a pointer is on an element, from its corner and in its own pixels, which a page may have scaled. */
export function pointIn(
  element: HTMLElement,
  { clientX, clientY }: MouseEvent,
): { x: number; y: number } {
  const { left, top, width } = element.getBoundingClientRect()
  const own = element.offsetWidth
  // It is in whole pixels: a smaller difference is none.
  const scale = Math.abs(own - width) < 1 ? 1 : own / width
  return { x: (clientX - left) * scale, y: (clientY - top) * scale }
}

/** What a slider's keys need to know of it. */
interface Slider {
  readonly from: number
  readonly to: number
  readonly step: number
}

const moves: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 10,
  PageDown: -10,
}

/** The value that a key of a slider leads to, which may be beyond its ends; undefined for any other key. */
export function valueByKey(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  { from, to, step }: Slider,
  value: number,
): number | undefined {
  if (key === 'Home') return from
  if (key === 'End') return to
  const steps = moves[key]
  if (steps === undefined) return undefined
  // Rounded, so that 0.1 + 0.2 is 0.3.
  return Number((value + steps * step * (shiftKey ? 10 : 1)).toPrecision(12))
}

let count = 0

/** An id that no other element of the page has: several labs can stand on one page. */
export function freshId(prefix: string): string {
  return `${prefix}-${++count}`
}
