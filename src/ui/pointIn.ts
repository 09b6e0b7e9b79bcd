/** Where a pointer is on an element, from its corner and in its own pixels, which a page may have scaled. */
export function pointIn(
  element: HTMLElement,
  { clientX, clientY }: MouseEvent,
): { x: number; y: number } {
  const { left, top, width } = element.getBoundingClientRect()
  const own = element.offsetWidth
  // It is in whole pixels: a smaller difference is none.
  const scale = Math.abs(own - width) < 1 ? 1 : own / width
  return { x: (clientX - left) * scale, y: (clientY - top) * scale }
}
