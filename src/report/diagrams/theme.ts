import { readFileSync } from 'node:fs'
import { join } from 'node:path'

/** Text and lines; the palette's places; what is not ours. */
export const ink = 'var(--ink)'
export const softInk = 'var(--ink-soft)'
export const line = 'var(--line)'
export const runner = (colour: number) => `var(--runner-${colour})`

/**
 * The page's colours, light and dark, as a style for a drawing that stands alone. `svg:root` is a drawing that is its own
 * document: one that stands in a page takes the colours of the page.
 */
export function themeStyle(): string {
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
