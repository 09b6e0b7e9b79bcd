import { attributes, escaped } from '../still/html.ts'
import { hardCaseClaims, hardCases } from '../../measure/hardCases/index.ts'
import type { HardCase } from '../../measure/hardCases/index.ts'
import { hardCaseResults } from '../../measure/hardCases/results.ts'
import { groups, presetsOf } from '../../lab/presets/hardCases.ts'
import type { Preset } from '../../lab/presets/preset.ts'
import { writeAddress } from '../../lab/state/address.ts'
import { placeOf } from './book.ts'
import type { Env } from './book.ts'
import { claimRow } from './hardCaseFigures.ts'

/**
 * The hard cases: what to watch, every bound and what was measured, and links into the lab. A table for each kind, folded to a
 * line.
 */
export function hardCasesHtml(env: Env, line: number): string {
  const tables = groups.map(([name, numbers]) => {
    const cases = hardCases.filter(({ group }) => numbers.includes(group))
    for (const { id } of cases) env.book.give(anchorOf(id), placeOf(env, line))
    const label = attributes({ 'data-label': `Hard cases: ${name}` })
    const id = `hard-cases-${name.toLowerCase().replaceAll(' ', '-')}`
    env.book.give(id, placeOf(env, line))
    const claims = cases.flatMap((each) => Object.keys(hardCaseClaims[each.id]!)).length
    return `<details><summary><h3 id="${id}"><a href="#${id}">${escaped(name)}</a></h3>
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
