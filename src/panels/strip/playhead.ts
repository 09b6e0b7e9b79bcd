import { cleared } from '../../chart/pen.ts'

/** Where the cursor on time is, on a canvas over a strip and the slider above it [px]. */
export interface Playhead {
  /** Of the canvas: it reaches beyond the strip's ends by half of the slider's thumb. */
  readonly width: number
  readonly height: number
  /** Of the strip. */
  readonly length: number
  readonly depth: number
  /** From the strip's beginning. */
  readonly at: number
  /** Whether it moves: then the slider leaves its thumb to this canvas. */
  readonly moves: boolean
}

/**
 * Draws the cursor on time. On a canvas, since to move a part of the page, or the thumb of a slider, has the browser work
 * out anew what lies above what: that takes longer than to draw all of this.
 */
export function drawPlayhead(
  canvas: HTMLCanvasElement,
  { width, height, length, depth, at, moves }: Playhead,
  { accent, sheet }: { readonly accent: string; readonly sheet: string },
): void {
  const pen = cleared(canvas, width, height)
  const half = (width - length) / 2
  const top = height - depth
  const x = half + at
  pen.fillStyle = pen.strokeStyle = accent
  // On a whole pixel of the screen: between two it would be a blur of both.
  pen.fillRect(Math.round(x * devicePixelRatio) / devicePixelRatio, top, 1, depth)
  if (!moves) return
  pen.fillRect(0, Math.round(top / 2 - 1.5), x, 3)
  pen.beginPath()
  pen.arc(x, top / 2, half - 1, 0, 2 * Math.PI)
  pen.fillStyle = sheet
  pen.fill()
  pen.lineWidth = 2
  pen.stroke()
}
