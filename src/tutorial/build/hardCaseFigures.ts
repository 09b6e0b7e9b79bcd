import { attributes, escaped } from '../still/html.ts'
import type { Bound, Claim, Unit } from '../../measure/hardCases/hardCase.ts'
import type { Result } from '../../measure/hardCases/results.ts'
import { count, metres, plain, raw } from '../../chart/numbers.ts'

const thin = '\u202f'
const ROUNDING = '0 (to rounding)'

/** A claim with its bound and what was measured, as a row of a table. */
export function claimRow(claim: Claim, { run, runs, value, bound }: Result): string {
  const { what, why, unit, failure } = claim
  const measured = { title: digits(value, unit) }
  const given = { title: boundDigits(bound, unit) }
  const verdict = failure ? `<span class="failure">${escaped(failure)}: as documented</span>` : ''
  const which = what.includes(run) ? '' : whichRun(run, runs, bound)
  return `<tr><th scope="row">${unbroken(what)} <span class="why">${unbroken(why)}</span></th>
<td${attributes(given)}>${unbroken(boundText(claim, bound))} ${verdict}</td>
<td${attributes(measured)}>${unbroken(valueText(claim, value))} ${which && `<span class="run">${escaped(which)}</span>`}</td></tr>`
}

/** A text as HTML whose numbers stay on one line, with their units. */
function unbroken(text: string): string {
  return escaped(text).replace(
    /\S+(?:\u202f\S+)+|\d+(?: \d{3})+/g,
    '<span class="together">$&</span>',
  )
}

/** Which run the figure is of, where there are several and not all have the same. */
function whichRun(run: string, runs: number, { atMost, atLeast }: Bound): string {
  if (runs === 1) return run
  const areAlike = atMost === 0 || (atMost !== undefined && atMost === atLeast)
  return areAlike ? `all ${count(runs)} runs` : `${run}, of ${count(runs)} runs`
}

/** “0 (to rounding)”, “≤ 0.23 m”, “1 s to 5 s”, “exactly 50”. */
export function boundText({ unit, rounding }: Claim, { atMost, atLeast, above }: Bound): string {
  if (rounding) return ROUNDING
  if (above !== undefined) return `more than ${figure(above, unit)}`
  if (atMost === undefined) return `at least ${figure(atLeast!, unit)}`
  if (atMost === 0 || atMost === atLeast) return `exactly ${figure(atMost, unit)}`
  if (atLeast === undefined) return `≤${thin}${figure(atMost, unit)}`
  const [from, to] = [figure(atLeast, unit), figure(atMost, unit)]
  return from === to ? to : `${from} to ${to}`
}

/** What was measured, as people read it. */
export function valueText({ unit, rounding }: Claim, value: number): string {
  return rounding && value !== 0 ? ROUNDING : figure(value, unit)
}

function figure(value: number, unit: Unit): string {
  if (value === 0) return '0'
  if (unit === 'things') return Number.isInteger(value) ? count(value) : plain(value)
  if (unit === 'of the energy') return `${plain(100 * value)}${thin}%`
  if (unit === 'm') return value < 1e-6 ? `${plain(1e9 * value)}${thin}nm` : metres(value)
  return `${plain(value)}${thin}${unit}`
}

/** Every digit. */
function digits(value: number, unit: Unit): string {
  return unit === 'things' ? raw(value) : `${raw(value)} ${unit}`
}

function boundDigits({ atMost, atLeast, above }: Bound, unit: Unit): string {
  const parts: [string, number | undefined][] = [
    ['at least', atLeast],
    ['more than', above],
    ['at most', atMost],
  ]
  return parts
    .filter(([, value]) => value !== undefined)
    .map(([words, value]) => `${words} ${digits(value!, unit)}`)
    .join(', ')
}
