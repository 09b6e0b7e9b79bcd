import type { SliderRange } from '../physics/index.ts'

/**
 * Where a number stands on a slider's own scale: the number, or where the slider is logarithmic its decimal logarithm.
 */
export function placeOf({ scale }: SliderRange, value: number): number {
  return scale ? Math.log10(value) : value
}

/**
 * The number at a place of that scale: on a logarithmic one with a single digit, so that three steps a decade are 1, 2,
 * 5.
 */
export function valueAt({ scale }: SliderRange, place: number): number {
  // Rounded to what the slider can say, so that 0.1 + 0.2 is 0.3.
  return scale ? Number((10 ** place).toPrecision(1)) : Number(place.toPrecision(12))
}

/** The number that is `steps` steps of a slider away from another. It may be beyond the slider's ends. */
export function stepped(slider: SliderRange, value: number, steps: number): number {
  const { scale, step } = slider
  const place = placeOf(slider, value)
  // From between two steps it goes to the next one.
  const start = scale ? Math.round(place / step) * step : place
  return valueAt(slider, start + steps * step)
}
