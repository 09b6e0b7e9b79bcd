import { svg } from 'lit'
import { markText } from '../view/marks.ts'

/** A mark of the palette, the same as on a canvas, as a piece of SVG around a point. */
export function svgMark(look: number, x: number, y: number, radius: number) {
  return svg`<path class="mark" d=${markText(look)} transform="translate(${round(x)} ${round(y)}) scale(${radius})" />`
}

/** To a hundredth of a pixel. */
export function round(value: number): number {
  return Math.round(value * 100) / 100
}
