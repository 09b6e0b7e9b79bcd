import { html, LitElement, svg } from 'lit'
import { markText } from '../view/marks.ts'

/**
 * A runner's mark in its colour, the one that its dots have in the picture.
 *
 * - `look`: its place in the palette and the list of marks
 * - `hollow`: only its outline, for a runner that is hidden
 */
class RunnerMark extends LitElement {
  static override properties = { look: { type: Number }, hollow: { type: Boolean } }

  declare look: number
  declare hollow: boolean

  override createRenderRoot(): this {
    return this
  }

  // SVG, not a canvas: a browser asks every canvas of a page for its picture at every frame.
  override render() {
    const { look, hollow } = this
    const colour = `var(--runner-${look})`
    return html`<svg aria-hidden="true" viewBox="-1.25 -1.25 2.5 2.5">
      <path
        d=${markText(look)}
        .style="fill: ${hollow ? 'none' : colour}; stroke: ${hollow ? colour : 'none'}"
      ></path>
    </svg>`
  }
}

/** A mark of the palette, the same as on a canvas, as a piece of SVG around a point. */
export function svgMark(look: number, x: number, y: number, radius: number) {
  return svg`<path class="mark" d=${markText(look)} transform="translate(${round(x)} ${round(y)}) scale(${radius})" />`
}

/** To a hundredth of a pixel. */
export function round(value: number): number {
  return Math.round(value * 100) / 100
}

customElements.define('runner-mark', RunnerMark)
