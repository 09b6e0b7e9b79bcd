import { vi } from 'vitest'
import type { Box, Point } from '../../src/chart/geometry.ts'
import { SvgMatrix } from '../../src/tutorial/still/matrix.ts'
import { SvgPath } from '../../src/tutorial/still/svgPath.ts'
import type { Palette } from '../../src/view/palette.ts'

/** A word as it stands on a paper, and a straight line. */
export interface Word extends Box {
  readonly text: string
}
export interface Line {
  readonly from: Point
  readonly to: Point
  readonly width: number
  readonly colour: string
  readonly isDashed: boolean
}

/** A canvas that keeps where words and lines stand: every letter is about as wide as in a plain sans. */
export function paper() {
  const words: Word[] = []
  const lines: Line[] = []
  let path: [from: Point, to: Point][] = []
  let at: Point = { x: 0, y: 0 }
  const own = {
    font: '12px sans',
    lineWidth: 1,
    strokeStyle: '',
    isDashed: false,
    measureText: (text: string) => ({ width: widthIn(own.font, text) }),
    fillText: (text: string, x: number, y: number) => {
      const height = 0.72 * sizeOf(own.font)
      words.push({ text, left: x, right: x + widthIn(own.font, text), top: y - height, bottom: y })
    },
    setLineDash: (dash: number[]) => (own.isDashed = dash.length > 0),
    beginPath: () => (path = []),
    moveTo: (x: number, y: number) => (at = { x, y }),
    lineTo: (x: number, y: number) => path.push([at, (at = { x, y })]),
    stroke: () => {
      const { lineWidth: width, strokeStyle: colour, isDashed } = own
      lines.push(...path.map(([from, to]) => ({ from, to, width, colour, isDashed })))
    },
  }
  const context = new Proxy(own, {
    get: (target, key) => Reflect.get(target, key) ?? (() => undefined),
    set: (target, key, value) => Reflect.set(target, key, value),
  }) as unknown as CanvasRenderingContext2D
  return { words, lines, context }
}

/** Colours that tell whose a line is. */
export const plainPalette = {
  sans: 'sans',
  serif: 'serif',
  ink: 'ink',
  runners: Array.from({ length: 8 }, (_, i) => ({ fill: `fill ${i}`, text: `text ${i}` })),
  arrows: {},
} as unknown as Palette

/** What a browser has and Node has not: a picture keeps some of its paths, so they are those of the pictures in the page. */
export function stubPaths(): void {
  vi.stubGlobal('Path2D', SvgPath)
  vi.stubGlobal('DOMMatrix', SvgMatrix)
}

function sizeOf(font: string): number {
  return Number(/(\d+)px/.exec(font)![1])
}

function widthIn(font: string, text: string): number {
  return 0.56 * sizeOf(font) * text.length
}
