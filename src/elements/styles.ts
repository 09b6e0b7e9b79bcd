import css from '../styles/elements.css?inline'

/**
 * What the page says of its own text ends at the edge; the caption is the page's. `--slide-unit` is what the styles' rem
 * is here: the text size that the reader has chosen, or that of `--size`, whatever the page's own root has.
 *
 * Where the page asks how wide it would like to be, in a row or a table, it is as wide as a column of text.
 *
 * `column-rule-color` shows nothing: it is what shadow.ts reads the page's colour scheme from. By `step-start` it has its
 * new value as soon as its transition runs.
 *
 * On paper there is nothing to press, as in print.css.
 */
const shell = `
:host { display: block; min-width: 0; break-inside: avoid; --size: medium }
:host([hidden]) { display: none }
.edge { all: initial; display: block; direction: ltr; font-size: var(--size); --slide-unit: 1em; color-scheme: light; color: var(--ink) }
:host(:state(dark)) .edge { color-scheme: dark }
.edge > * { contain-intrinsic-inline-size: min(40rem, 80vw) }
slot { display: block }
slide-figure-root > slot, .problem { margin: 0; padding: 1em 1.25em }
.problem { color: var(--wrong) }
[name] { column-rule-color: light-dark(#000, #fff); transition: column-rule-color 1ms step-start }
:host([theme=light]) [name=caption] { color-scheme: light }
:host([theme=dark]) [name=caption] { color-scheme: dark }
@media print {
  .sheet > :not(slide-stage), .controls, .transport-line, .refusal { display: none !important }
  .below { min-height: 0 !important }
}
`

/** The font size of both roots, in which containers measure themselves [rem]. */
const ROOT_FONT = 0.875

const sheets = new WeakMap<Window, CSSStyleSheet>()

/** The styles of both elements, for their shadow roots in the page of a window: no other page takes that page's. */
export function styles(view: Window & typeof globalThis): CSSStyleSheet {
  const known = sheets.get(view)
  if (known) return known
  const sheet = new view.CSSStyleSheet()
  sheets.set(view, sheet)
  sheet.replaceSync(shell + inUnits(inShadow(css)))
  const unit = { name: '--slide-unit', syntax: '<length>', inherits: true, initialValue: '16px' }
  try {
    view.CSS.registerProperty(unit)
  } catch {
    // Another copy of this module has done it.
  }
  return sheet
}

/** Styles whose lengths don't depend on the text size of the page's root. */
export function inUnits(text: string): string {
  return text
    .replace(/@container[^{]*/g, (query) =>
      query.replace(/([\d.]+)rem/g, (_, rem) => `${Number(rem) / ROOT_FONT}em`),
    )
    .replace(/(-?[\d.]+)rem/g, 'calc($1 * var(--slide-unit))')
}

/** The page's styles with selectors that say the same inside a shadow root; shadow.ts says which theme it is. */
function inShadow(text: string): string {
  return text
    .replace(/\bslide-(lab|figure)\b(?!-)(?!:not\(:defined)/g, 'slide-$1-root')
    .replace(/:root:not\(\[[^\]]*\]\)/g, ':host(:not(*))')
    .replace(/:root/g, ':host')
    .replace(/\[data-theme=[^\]]*\]/g, ':host(:state(dark))')
    .replace(/(?<!-)(color-scheme|--lightningcss-\w+):[^;}]*;?/g, '')
}
