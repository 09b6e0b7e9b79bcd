import { plain } from '../../chart/numbers.ts'

/** A number of the prose: how it comes about, and how it is written. */
export interface Fact {
  value(): number
  show(value: number): string
}

export type Facts = Readonly<Record<string, Fact>>

/** “1.8 %”, with a thin space. */
export function percent(value: number): string {
  return `${plain(100 * value)}\u202f%`
}

/** A distance that is nothing at all, to the last bit, is said to be so. */
export function exactly(show: (value: number) => string): (value: number) => string {
  return (value) => (value === 0 ? '0\u202fm' : show(value))
}
