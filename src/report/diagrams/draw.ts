import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import * as Plot from '@observablehq/plot'
import { parseHTML } from 'linkedom'
import type { Diagram } from '../schema/index.ts'

/** A diagram: what it is, and the file's content. */
export interface DiagramDrawing {
  readonly about: Diagram
  readonly svg: string
}

/**
 * Draws a plot as a file of its own: with a title and a description for those who don't see it, and with the page's
 * colours, light or dark as the system is set.
 */
export function draw(about: Diagram, options: Plot.PlotOptions): DiagramDrawing {
  const { document } = parseHTML('<html><body></body></html>')
  const svg = Plot.plot({
    document,
    width: 720,
    height: 460,
    marginLeft: 64,
    marginBottom: 44,
    marginTop: 28,
    className: 'chart',
    style: {
      color: 'var(--ink)',
      fontFamily: 'system-ui, sans-serif',
      fontSize: '12px',
      fontVariant: 'tabular-nums',
    },
    ...options,
  })
  const name = about.file.replace(/\.svg$/, '')
  svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg')
  svg.setAttribute('role', 'img')
  svg.setAttribute('aria-labelledby', `${name}-title ${name}-description`)
  const add = (tag: string, text: string, id?: string) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', tag)
    if (id) element.setAttribute('id', id)
    element.textContent = text
    return element
  }
  svg.prepend(
    add('title', about.title, `${name}-title`),
    add('desc', about.description, `${name}-description`),
    add('style', themeStyle()),
  )
  return { about, svg: `${svg.outerHTML}\n` }
}

/** Powers of ten for an axis, by one or by several decades, so that there are not many; 1 is among them if in reach. */
export function powers(least: number, most: number, by?: number): number[] {
  const from = Math.log10(least) - 1e-9
  const to = Math.log10(most) + 1e-9
  const decades = by ?? (to - from > 6 ? 3 : 1)
  const first = Math.ceil(from / decades)
  const last = Math.floor(to / decades)
  return Array.from({ length: last - first + 1 }, (_, i) => 10 ** ((first + i) * decades))
}

/** A power of a thousand of a metre on an axis: “1 nm”. */
export function metricPower(value: number): string {
  const thousands = Math.round(Math.log10(value) / 3)
  const unit = ['fm', 'pm', 'nm', 'µm', 'mm', 'm', 'km'][thousands + 5]
  return unit ? `1 ${unit}` : `${value} m`
}

/** Text and lines; the palette's places; what is not ours. */
export const ink = 'var(--ink)'
export const softInk = 'var(--ink-soft)'
export const line = 'var(--line)'
export const runner = (colour: number) => `var(--runner-${colour})`

/**
 * The page's colours, light and dark, as a style for a drawing that stands alone. `svg:root` is a drawing that is its own
 * document: one that stands in a page takes the colours of the page.
 */
function themeStyle(): string {
  const css = readFileSync(join(process.cwd(), 'src/styles/theme.css'), 'utf8')
  const colours = (start: RegExp) =>
    [...block(css, start).matchAll(/--(?:ink|ink-soft|line|sheet|runner-\d): [^;]+;/g)].join(' ')
  const light = colours(/:root \{/)
  const dark = colours(/\[data-theme='dark'\] \{/)
  return `svg:root { ${light} background: var(--sheet); } @media (prefers-color-scheme: dark) { svg:root { ${dark} } }`
}

function block(css: string, start: RegExp): string {
  const from = css.search(start)
  return css.slice(from, css.indexOf('}', from))
}

/** A line of a legend: colour, and a shape for those who tell colours badly. */
interface Key {
  readonly label: string
  readonly colour: string
  readonly symbol: Plot.SymbolType
}

/** Marks to the right of a plot: one line below the other. */
export function legend(keys: readonly Key[]): Plot.Markish[] {
  return keys.flatMap(({ label, colour, symbol }, row) => [
    Plot.dot([0], {
      frameAnchor: 'top-right',
      dx: 22,
      dy: 8 + 20 * row,
      symbol,
      fill: colour,
      r: 4.5,
      clip: false,
    }),
    Plot.text([label], {
      frameAnchor: 'top-right',
      lineAnchor: 'middle',
      textAnchor: 'start',
      dx: 34,
      dy: 8 + 20 * row,
      fill: 'var(--ink)',
    }),
  ])
}
