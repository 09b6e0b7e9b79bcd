import { html, LitElement, svg } from 'lit'
import { drawMark } from '../view/marks.ts'

/**
 * A runner's mark in its colour, the one that its dots have in the picture.
 *
 * - `paletteIndex`: its place in the palette and the list of marks
 * - `hollow`: only its outline, for a runner that is hidden
 */
class RunnerMark extends LitElement {
  static override properties = { paletteIndex: { type: Number }, hollow: { type: Boolean } }

  declare paletteIndex: number
  declare hollow: boolean

  override createRenderRoot(): this {
    return this
  }

  // SVG, not a canvas: browsers composite every canvas of a page at every frame.
  override render() {
    const { paletteIndex, hollow } = this
    const colour = `var(--runner-${paletteIndex})`
    return html`<svg aria-hidden="true" viewBox="-1.25 -1.25 2.5 2.5">
      <path
        d=${markText(paletteIndex)}
        .style="fill: ${hollow ? 'none' : colour}; stroke: ${hollow ? colour : 'none'}"
      ></path>
    </svg>`
  }
}

/** A mark of the palette, the same as on a canvas, as a piece of SVG around a point. */
export function svgMark(paletteIndex: number, x: number, y: number, radius: number) {
  return svg`<path class="mark" d=${markText(paletteIndex)} transform="translate(${round(x)} ${round(y)}) scale(${radius})" />`
}

/** Rounds to a hundredth of a pixel. */
export function round(value: number): number {
  return Math.round(value * 100) / 100
}

/** A mark around the origin, of radius 1, as the value of a path element's `d`. */
function markText(paletteIndex: number): string {
  const path = new MarkPath()
  drawMark(path, paletteIndex)
  return path.text
}

/** A path as the text that SVG knows it by: the calls of a canvas's path that shapes here are made of. */
class MarkPath {
  private readonly parts: string[] = []

  /** The value of a path element's `d`. */
  get text(): string {
    return this.parts.join('')
  }

  lineTo(x: number, y: number): void {
    this.parts.push(`${this.parts.length > 0 ? 'L' : 'M'}${short(x)} ${short(y)}`)
  }

  closePath(): void {
    this.parts.push('Z')
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.parts.push(`M${short(x)} ${short(y)}h${short(width)}v${short(height)}h${short(-width)}Z`)
  }

  /** Only whole circles. */
  arc(x: number, y: number, radius: number, _: number, __: number, against = false): void {
    const half = `a${short(radius)} ${short(radius)} 0 0 ${against ? 0 : 1} `
    const across = short(2 * radius)
    this.parts.push(`M${short(x - radius)} ${short(y)}${half}${across} 0${half}-${across} 0Z`)
  }
}

function short(x: number): string {
  return String(Number(x.toFixed(3)))
}

customElements.define('slide-runner-mark', RunnerMark)
