import { textWidth } from './advances.ts'
import { attributes, escaped } from './html.ts'
import type { Attributes } from './html.ts'
import { applied, magnification } from './matrix.ts'
import { decoded, encoded } from './palette.ts'
import { short, SvgPath } from './svgPath.ts'
import { precise, SvgState } from './svgState.ts'

/**
 * A canvas's context that writes SVG: as much of it as pictures use. Colours stay the custom properties that they are
 * given as, so that one picture serves both themes.
 */
export class SvgContext extends SvgState {
  readonly elements: string[] = []
  private path = new SvgPath()
  /** The rim that was just drawn around a text which may follow. */
  private rim = ''

  constructor(
    readonly canvas: { width: number; height: number },
    /** In front of the ids within the picture, which are unique in the page. */
    private readonly name: string,
  ) {
    super()
  }

  beginPath(): void {
    this.path = new SvgPath()
  }

  closePath(): void {
    this.path.closePath()
  }

  moveTo(x: number, y: number): void {
    this.path.moveTo(...applied(this.matrix, x, y))
  }

  lineTo(x: number, y: number): void {
    this.path.lineTo(...applied(this.matrix, x, y))
  }

  arc(x: number, y: number, radius: number, from: number, to: number, backwards = false): void {
    const { a, b } = this.matrix
    const turned = Math.atan2(b, a)
    const centre = applied(this.matrix, x, y)
    const size = radius * magnification(this.matrix)
    this.path.arc(...centre, size, from + turned, to + turned, backwards)
  }

  rect(x: number, y: number, width: number, height: number): void {
    const path = new SvgPath()
    path.rect(x, y, width, height)
    this.path.addPath(path, this.matrix)
  }

  roundRect(x: number, y: number, width: number, height: number, radius: number): void {
    const path = new SvgPath()
    path.roundRect(x, y, width, height, radius)
    this.path.addPath(path, this.matrix)
  }

  clip(): void {
    const id = `${this.name}-clip-${this.elements.length}`
    // Within the one that is there.
    const outer = attributes({ 'clip-path': this.clipped || undefined })
    this.elements.push(`<clipPath id="${id}"${outer}><path d="${this.path.data}"/></clipPath>`)
    this.clipped = `url(#${id})`
  }

  fill(path?: SvgPath): void {
    this.add(path, { fill: decoded(this.fillStyle), ...this.shared() })
  }

  stroke(path?: SvgPath): void {
    this.add(path, { fill: 'none', ...this.lines(), ...this.shared() })
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    const path = new SvgPath()
    path.rect(x, y, width, height)
    this.fill(path)
  }

  measureText(text: string): { width: number } {
    return { width: textWidth(text, this.font) }
  }

  strokeText(text: string, x: number, y: number): void {
    this.write(text, x, y, { fill: 'none', ...this.lines() })
    this.rim = textElement(this, text, x, y)
  }

  /** A text that fills its own rim is one element with it. */
  fillText(text: string, x: number, y: number): void {
    if (this.rim !== '' && this.rim === textElement(this, text, x, y)) {
      const rim = this.elements.pop()!
      const fill = attributes({ fill: decoded(this.fillStyle), 'paint-order': 'stroke' })
      this.elements.push(rim.replace(' fill="none"', fill))
      this.rim = ''
    } else this.write(text, x, y, { fill: decoded(this.fillStyle) })
  }

  /** Another canvas's picture. */
  drawImage(image: { getContext: () => SvgContext }): void {
    this.elements.push(...image.getContext().elements)
  }

  /** Of the one pixel that was just filled. */
  getImageData(): { data: readonly number[] } {
    return { data: encoded(this.fillStyle) }
  }

  private add(path: SvgPath | undefined, values: Attributes): void {
    const data = path ? path.moved(this.matrix).data : this.path.data
    this.rim = ''
    if (data !== '') this.elements.push(`<path d="${data}"${attributes(values)}/>`)
  }

  private write(text: string, x: number, y: number, values: Attributes): void {
    this.rim = ''
    this.elements.push(textElement(this, text, x, y, { ...values, ...this.shared() }))
  }
}

/** A text from a point on its baseline to the right, as src/view/text.ts writes all, in the state's font and matrix. */
function textElement(
  state: SvgState,
  text: string,
  x: number,
  y: number,
  values: Attributes = {},
): string {
  const matrix = state.getTransform()
  const { a, b, c, d, e, f } = matrix
  const isPlain = a === 1 && b === 0 && c === 0 && d === 1
  const [left, top] = isPlain ? applied(matrix, x, y) : [x, y]
  const transform = isPlain ? undefined : `matrix(${[a, b, c, d, e, f].map(precise).join(' ')})`
  const place = { x: short(left), y: short(top), transform }
  const all = { ...place, ...values, style: `font:${state.font}` }
  return `<text${attributes(all)}>${escaped(text)}</text>`
}
