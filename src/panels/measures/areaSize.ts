import type { LitElement } from 'lit'

/**
 * Follows the size of the `.area` in an element, which is drawn again when its width is another; its height follows
 * from that.
 *
 * @returns the size as it is at any time, the width to a whole pixel [px]
 */
export function areaSize(host: LitElement): { readonly width: number; readonly height: number } {
  const size = { width: 0, height: 0 }
  const observer = new ResizeObserver(([entry]) => {
    const { width, height } = entry!.contentRect
    size.height = height
    if (Math.round(width) === size.width) return
    size.width = Math.round(width)
    host.requestUpdate()
  })
  host.addController({
    hostUpdated: () => observer.observe(host.querySelector('.area')!),
    hostDisconnected: () => observer.disconnect(),
  })
  return size
}
