import { textWidth } from './advances.ts'
import { attributes, escaped } from '../html.ts'
import { decoded, encoded } from './colourCode.ts'
import { applied, identity, product, scaleOf } from './matrix.ts'
import type { Matrix } from './matrix.ts'
import { short, SvgPath } from './svgPath.ts'

/** What a canvas remembers with `save`. */
const initial = {
  fillStyle: '#000',
  strokeStyle: '#000',
  lineWidth: 1,
  lineCap: 'butt',
  lineJoin: 'miter',
  lineDashOffset: 0,
  globalAlpha: 1,
  font: '10px sans-serif',
  textAlign: 'left',
  textBaseline: 'alphabetic',
  dash: [] as readonly number[],
  matrix: identity,
  clip: '',
}

/** How a text stands on the point it is written at. */
const anchors: Readonly<Record<string, string | undefined>> = {
  center: 'middle',
  right: 'end',
  end: 'end',
}
const baselines: Readonly<Record<string, string | undefined>> = {
  middle: 'central',
  top: 'text-before-edge',
  bottom: 'text-after-edge',
}

/**
 * A canvas's context that writes SVG: as much of it as pictures use. Colours stay the custom properties that they are
 * given as, so that one picture serves both themes.
 */
export class SvgContext {
  fillStyle = initial.fillStyle
  strokeStyle = initial.strokeStyle
  lineWidth = initial.lineWidth
  lineCap = initial.lineCap
  lineJoin = initial.lineJoin
  lineDashOffset = initial.lineDashOffset
  globalAlpha = initial.globalAlpha
  font = initial.font
  textAlign = initial.textAlign
  textBaseline = initial.textBaseline
  readonly elements: string[] = []
  private dash = initial.dash
  private matrix: Matrix = identity
  private clipped = initial.clip
  private path = new SvgPath()
  private readonly saved: (typeof initial)[] = []
  /** The rim that was just drawn around a text which may follow. */
  private rim = ''

  constructor(
    readonly canvas: { width: number; height: number },
    /** In front of the ids within the picture, which are unique in the page. */
    private readonly name: string,
  ) {}

  save(): void {
    const { fillStyle, strokeStyle, lineWidth, lineCap, lineJoin, lineDashOffset } = this
    const { globalAlpha, font, textAlign, textBaseline, dash, matrix, clipped: clip } = this
    const lines = { strokeStyle, lineWidth, lineCap, lineJoin, lineDashOffset, dash }
    const texts = { font, textAlign, textBaseline }
    this.saved.push({ fillStyle, ...lines, ...texts, globalAlpha, matrix, clip })
  }

  restore(): void {
    const state = this.saved.pop()
    if (!state) return
    const { matrix, dash, clip, ...others } = state
    Object.assign(this, others)
    this.matrix = matrix
    this.dash = dash
    this.clipped = clip
  }

  translate(x: number, y: number): void {
    this.matrix = product(this.matrix, { ...identity, e: x, f: y })
  }

  rotate(angle: number): void {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
    this.matrix = product(this.matrix, { ...identity, a: cos, b: sin, c: -sin, d: cos })
  }

  scale(x: number, y: number): void {
    this.matrix = product(this.matrix, { ...identity, a: x, d: y })
  }

  setTransform(...given: [Matrix] | [number, number, number, number, number, number]): void {
    if (given.length === 1) this.matrix = given[0]
    else {
      const [a, b, c, d, e, f] = given
      this.matrix = { a, b, c, d, e, f }
    }
  }

  getTransform(): Matrix {
    return this.matrix
  }

  resetTransform(): void {
    this.matrix = identity
  }

  setLineDash(dash: readonly number[]): void {
    this.dash = dash
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

  quadraticCurveTo(x1: number, y1: number, x: number, y: number): void {
    this.path.quadraticCurveTo(...applied(this.matrix, x1, y1), ...applied(this.matrix, x, y))
  }

  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void {
    const [first, second] = [applied(this.matrix, x1, y1), applied(this.matrix, x2, y2)]
    this.path.bezierCurveTo(...first, ...second, ...applied(this.matrix, x, y))
  }

  arc(x: number, y: number, radius: number, from: number, to: number, backwards = false): void {
    const { a, b } = this.matrix
    const turned = Math.atan2(b, a)
    const centre = applied(this.matrix, x, y)
    const size = radius * scaleOf(this.matrix)
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

  strokeRect(x: number, y: number, width: number, height: number): void {
    const path = new SvgPath()
    path.rect(x, y, width, height)
    this.stroke(path)
  }

  /** Only ever all of it. */
  clearRect(): void {
    this.elements.length = 0
  }

  measureText(text: string): { width: number } {
    return { width: textWidth(text, this.font) }
  }

  strokeText(text: string, x: number, y: number): void {
    this.write(text, x, y, { fill: 'none', ...this.lines() })
    this.rim = this.text(text, x, y, {})
  }

  /** A text that fills its own rim is one element with it. */
  fillText(text: string, x: number, y: number): void {
    if (this.rim !== '' && this.rim === this.text(text, x, y, {})) {
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

  private add(
    path: SvgPath | undefined,
    values: Readonly<Record<string, string | number | undefined>>,
  ): void {
    const data = path ? path.moved(this.matrix).data : this.path.data
    this.rim = ''
    if (data !== '') this.elements.push(`<path d="${data}"${attributes(values)}/>`)
  }

  private write(
    text: string,
    x: number,
    y: number,
    values: Readonly<Record<string, string | number | undefined>>,
  ): void {
    this.rim = ''
    this.elements.push(this.text(text, x, y, { ...values, ...this.shared() }))
  }

  private text(
    text: string,
    x: number,
    y: number,
    values: Readonly<Record<string, string | number | undefined>>,
  ): string {
    const { a, b, c, d, e, f } = this.matrix
    const isPlain = a === 1 && b === 0 && c === 0 && d === 1
    const [left, top] = isPlain ? applied(this.matrix, x, y) : [x, y]
    const transform = isPlain ? undefined : `matrix(${[a, b, c, d, e, f].map(precise).join(' ')})`
    const place = { x: short(left), y: short(top), transform }
    const anchor = { 'text-anchor': anchors[this.textAlign] }
    const baseline = { 'dominant-baseline': baselines[this.textBaseline] }
    const all = { ...place, ...values, ...anchor, ...baseline, style: `font:${this.font}` }
    return `<text${attributes(all)}>${escaped(text)}</text>`
  }

  private lines() {
    const { lineWidth, lineCap, lineJoin, dash, lineDashOffset } = this
    const width = lineWidth * scaleOf(this.matrix)
    return {
      stroke: decoded(this.strokeStyle),
      'stroke-width': width === 1 ? undefined : precise(width),
      'stroke-linecap': lineCap === 'butt' ? undefined : lineCap,
      'stroke-linejoin': lineJoin === 'miter' ? undefined : lineJoin,
      'stroke-dasharray': dash.length > 0 ? dash.map(precise).join(' ') : undefined,
      'stroke-dashoffset': lineDashOffset === 0 ? undefined : precise(lineDashOffset),
    }
  }

  private shared() {
    const { globalAlpha, clipped } = this
    return {
      opacity: globalAlpha === 1 ? undefined : precise(globalAlpha),
      'clip-path': clipped || undefined,
    }
  }
}

function precise(value: number): string {
  return String(Math.round(value * 1000) / 1000 + 0)
}
