import { SvgMatrix } from './matrix.ts'
import { SvgContext } from './svgContext.ts'
import { SvgPath } from './svgPath.ts'

/** A canvas that keeps what is drawn on it as SVG. */
class SvgCanvas {
  width = 0
  height = 0
  private readonly context: SvgContext

  constructor(name: string) {
    this.context = new SvgContext(this, name)
  }

  getContext(): SvgContext {
    return this.context
  }
}

/** What drawing code asks of the browser. */
const browser = (name: string) => ({
  Path2D: SvgPath,
  DOMMatrix: SvgMatrix,
  document: { createElement: () => new SvgCanvas(name) },
  window: { devicePixelRatio: 1 },
  getComputedStyle: () => ({ getPropertyValue: (property: string) => `var(${property})` }),
})

/**
 * What a function draws on a canvas of a size [px], as an SVG. Meanwhile the few globals that it asks of the browser are
 * there.
 *
 * @param name in front of the ids in the picture
 */
export function svgOf(
  name: string,
  { width, height }: { width: number; height: number },
  draw: (context: CanvasRenderingContext2D) => void,
): string {
  const scope = globalThis as Record<string, unknown>
  const stood = Object.keys(browser(name)).map((key) => [key, scope[key]] as const)
  Object.assign(scope, browser(name))
  const context = new SvgContext({ width, height }, name)
  try {
    draw(context as unknown as CanvasRenderingContext2D)
  } finally {
    for (const [key, value] of stood) {
      if (value === undefined) Reflect.deleteProperty(scope, key)
      else scope[key] = value
    }
  }
  return `<svg viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" aria-hidden="true">${context.elements.join('')}</svg>`
}
