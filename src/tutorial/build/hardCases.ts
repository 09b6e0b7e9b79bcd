import { hardCaseClaims } from '../../measure/hardCases/claims.ts'
import { hardCases } from '../../measure/hardCases/index.ts'
import type { HardCase } from '../../measure/hardCases/index.ts'
import { hardCaseResults } from '../../measure/hardCases/results.ts'
import type { Result } from '../../measure/hardCases/results.ts'
import type { Bound, Claim, Unit } from '../../measure/hardCases/hardCase.ts'
import { count, metres, plain, raw } from '../../chart/numbers.ts'
import { groups, presetsOf } from '../../lab/presets/hardCases.ts'
import type { Preset } from '../../lab/presets/preset.ts'
import { writeAddress } from '../../lab/state/address.ts'
import { attributes, escaped } from '../still/html.ts'
import { textPlaceOf } from './book.ts'
import type { Env } from './book.ts'

/**
 * The hard cases: what to watch, every bound and what was measured, and links into the lab. A table for each kind, folded to a
 * line.
 */
export function hardCasesHtml(env: Env, line: number): string {
  const tables = groups.map(([name, numbers]) => {
    const cases = hardCases.filter(({ group }) => numbers.includes(group))
    for (const { id } of cases) env.book.give(anchorOf(id), textPlaceOf(env, line))
    const label = attributes({ 'data-label': `Hard cases: ${name}` })
    const id = `hard-cases-${name.toLowerCase().replaceAll(' ', '-')}`
    env.book.give(id, textPlaceOf(env, line))
    const claims = cases.flatMap((each) => Object.keys(hardCaseClaims[each.id]!)).length
    return `<details><summary><h3 id="${id}">${escaped(name)}</h3>
<span class="counts">${cases.length} cases, ${claims} numbers</span></summary>
<div class="table"${label}><table>
<thead><tr><th scope="col">Quantity</th><th scope="col">Bound</th><th scope="col">Measured</th></tr></thead>
${cases.map((each) => caseHtml(each, presetsOf(each, name))).join('\n')}
</table></div></details>`
  })
  return `<div class="hard-cases">\n${tables.join('\n')}\n</div>\n`
}

const anchorOf = (id: string) => `hard-case-${id}`

function caseHtml({ id, label, watch, group, experiments, refused }: HardCase, presets: Preset[]) {
  // What a preset says beyond the case: that it is shown in part.
  const remarks = new Set(
    presets.map((preset) => preset.watch.slice(watch.length).replace('here.', 'in the lab.')),
  )
  const links = presets.map((preset) => {
    const part = preset.label.slice(label.length).replace(/^: /, '')
    const address = refused ? refusedAddress(experiments) : writeAddress(preset.shown.state)
    const values = { href: `#${address}`, 'data-lab': '' }
    const name = { 'aria-label': `Open in the lab: ${preset.label}` }
    return `<a${attributes({ ...values, ...name })}>${escaped(part || 'Open in the lab')}</a>`
  })
  const lead = links.length > 1 ? 'Open in the lab: ' : ''
  const rows = Object.entries(hardCaseClaims[id]!).map(([claim, words]) =>
    claimRow(words, hardCaseResults[id]![claim]!),
  )
  return `<tbody${attributes({ id: anchorOf(id), 'data-group': group })}>
<tr><th colspan="3" scope="rowgroup"><a class="name" href="#${anchorOf(id)}">${escaped(label)}</a>
<span class="watch">${escaped(watch + [...remarks].join(''))}</span>
<span class="links">${lead}${links.join(' · ')}</span></th></tr>
${rows.join('\n')}
</tbody>`
}

/** The link of an experiment that can’t be run: the lab says why. */
function refusedAddress([experiment]: HardCase['experiments']): string {
  const { scene, parameters } = experiment!
  return new URLSearchParams({
    scene,
    ...Object.fromEntries(Object.entries(parameters ?? {}).map(([key, x]) => [key, String(x)])),
  }).toString()
}

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
