import type { Box } from '../../chart/geometry.ts'

/** The part of a chart of that size in which there are curves; the labels of the axes are to its left and below it [px]. */
export function boxOf(width: number, height: number): Box {
  return { left: 66, top: 8, right: width - 14, bottom: height - 24 }
}

/** Lets a pen draw only so near to a box [px]. */
export function clip(pen: CanvasRenderingContext2D, box: Box, room: number): void {
  const { left, top, right, bottom } = box
  pen.beginPath()
  pen.rect(left - room, top - room, right - left + 2 * room, bottom - top + 2 * room)
  pen.clip()
}
