import * as Plot from '@observablehq/plot'

/** A line of a legend: colour, and a shape for those who tell colours badly. */
export interface Key {
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
