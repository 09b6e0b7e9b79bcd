import type { SliderRange } from '../physics/index.ts'
import { stepped } from './sliderScale.ts'

/** A pointer's position from an element's corner, in the element's own pixels, which a page may have scaled. */
export function pointIn(
  element: HTMLElement,
  { clientX, clientY }: MouseEvent,
): { x: number; y: number } {
  const { left, top, width } = element.getBoundingClientRect()
  const own = element.offsetWidth
  // offsetWidth is in whole pixels: ignore smaller differences.
  const scale = Math.abs(own - width) < 1 ? 1 : own / width
  return { x: (clientX - left) * scale, y: (clientY - top) * scale }
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
  slider: SliderRange,
  value: number,
): number | undefined {
  if (key === 'Home') return slider.from
  if (key === 'End') return slider.to
  const steps = moves[key]
  if (steps === undefined) return undefined
  return stepped(slider, value, shiftKey ? 10 * steps : steps)
}

let count = 0

/** An id that no other element of the page has: several labs can stand on one page. */
export function freshId(prefix: string): string {
  return `${prefix}-${++count}`
}
