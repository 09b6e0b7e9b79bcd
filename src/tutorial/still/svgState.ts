import { identity, product, magnification } from './matrix.ts'
import type { Matrix } from './matrix.ts'
import { decoded } from './palette.ts'

/** What a canvas remembers with `save`. */
const initial = {
  fillStyle: '#000',
  strokeStyle: '#000',
  lineWidth: 1,
  lineCap: 'butt',
  lineJoin: 'miter',
  globalAlpha: 1,
  font: '10px sans-serif',
  dash: [] as readonly number[],
  matrix: identity,
  clip: '',
}

/** The state of a canvas's context, with the names that the canvas gives it, and what of it becomes SVG attributes. */
export class SvgState {
  fillStyle = initial.fillStyle
  strokeStyle = initial.strokeStyle
  lineWidth = initial.lineWidth
  lineCap = initial.lineCap
  lineJoin = initial.lineJoin
  globalAlpha = initial.globalAlpha
  font = initial.font
  protected matrix: Matrix = identity
  protected clipped = initial.clip
  private dash = initial.dash
  private readonly saved: (typeof initial)[] = []

  save(): void {
    const { fillStyle, strokeStyle, lineWidth, lineCap, lineJoin } = this
    const { globalAlpha, font, dash, matrix, clipped: clip } = this
    const lines = { strokeStyle, lineWidth, lineCap, lineJoin, dash }
    this.saved.push({ fillStyle, ...lines, globalAlpha, font, matrix, clip })
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

  /** Of lines. */
  protected lines() {
    const { lineWidth, lineCap, lineJoin, dash } = this
    const width = lineWidth * magnification(this.matrix)
    return {
      stroke: decoded(this.strokeStyle),
      'stroke-width': width === 1 ? undefined : precise(width),
      'stroke-linecap': lineCap === 'butt' ? undefined : lineCap,
      'stroke-linejoin': lineJoin === 'miter' ? undefined : lineJoin,
      'stroke-dasharray': dash.length > 0 ? dash.map(precise).join(' ') : undefined,
    }
  }

  /** Of all that is drawn. */
  protected shared() {
    const { globalAlpha, clipped } = this
    return {
      opacity: globalAlpha === 1 ? undefined : precise(globalAlpha),
      'clip-path': clipped || undefined,
    }
  }
}

/** A number to its thousandths. */
export function precise(value: number): string {
  return String(Math.round(value * 1000) / 1000 + 0)
}
