import { clamp } from '../../chart/geometry.ts'
import type { Rgb } from '../../view/palette.ts'

/** Viridis (Smith and van der Walt, 2015): even to the eye, and to eyes that see fewer colours. */
const stops: readonly Rgb[] = [
  [68, 1, 84],
  [70, 50, 126],
  [54, 92, 141],
  [39, 127, 142],
  [31, 161, 135],
  [74, 193, 109],
  [160, 218, 57],
  [253, 231, 37],
]

/** The colour at a part of the ramp, 0 … 1, from the paper's side: pale first on light paper, dark first on dark. */
export function rampColour(part: number, dark: boolean): Rgb {
  const place = clamp(dark ? part : 1 - part, 0, 1) * (stops.length - 1)
  const below = Math.min(stops.length - 2, Math.floor(place))
  const rest = place - below
  const [from, to] = [stops[below]!, stops[below + 1]!]
  return from.map((value, i) => Math.round(value + rest * (to[i]! - value))) as unknown as Rgb
}

/** The same ramp for a legend. */
export function rampGradient(dark: boolean): string {
  const colours = stops.map((_, i) => `rgb(${rampColour(i / (stops.length - 1), dark).join(' ')})`)
  return `linear-gradient(to right, ${colours.join(', ')})`
}
