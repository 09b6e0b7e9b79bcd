import { html } from 'lit'

/** A quantity's symbol as it is set: the letter after a μ tells which μ it is. */
export function typeset(symbol: string) {
  return /^μ./.test(symbol) ? html`μ<sub>${symbol.slice(1)}</sub>` : symbol
}
