import { parseExperiment } from '../../physics/index.ts'
import type { Experiment, ExactMotion } from '../../physics/index.ts'
import { linkTo, writeAddress } from '../../lab/state/address.ts'
import { experimentOf } from '../../lab/state/check.ts'
import { namesOf } from '../../lab/state/names.ts'
import type { LabState } from '../../lab/state/state.ts'
import { errorAt } from '../../lab/state/simulation.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'

/**
 * HTML for other people's pages that shows a state in a frame of its own, which can do nothing but run its script. The
 * script beside it gives the frame the figure's height: a page that takes no scripts can do without.
 */
export function frameCode(site: string, state: LabState): string {
  const names = namesOf(state.runners).join(', ')
  const attributes = {
    src: linkTo('embed.html', site, state),
    title: `Any Frame Rate: ${state.scene}, ${names}`,
    width: '100%',
    height: '640',
    loading: 'lazy',
    sandbox: 'allow-scripts allow-downloads allow-popups allow-popups-to-escape-sandbox',
    // Not by a style attribute, which a careful page forbids.
    frameborder: '0',
  }
  const text = Object.entries(attributes).map(([name, value]) => `${name}="${escaped(value)}"`)
  const script = escaped(new URL('embed-resize.js', site).href)
  return `<iframe ${text.join(' ')}></iframe>\n<script src="${script}" async></script>`
}

/**
 * HTML for other people's pages that shows a state as a part of the page itself. Markdown leaves it as it is: a block that
 * begins with `<div>` is HTML as far as the next blank line. React runs a script only if it is `async`.
 */
export function elementCode(site: string, state: LabState): string {
  return ['<div>', ...elementLines(site, state), '</div>'].join('\n')
}

/** The same in one line, which also stays whole in a list, in a quotation, and in MDX, where lines become paragraphs. */
export function markdownCode(site: string, state: LabState): string {
  return `<div>${elementLines(site, state).join('')}</div>`
}

function elementLines(site: string, state: LabState): string[] {
  const script = escaped(new URL('slide-lab.js', site).href)
  const experiment = escaped(JSON.stringify(experimentsOf(state).map(brief)))
  return [
    `<script type="module" src="${script}" async></script>`,
    `<slide-lab compact experiment='${experiment.replaceAll('&quot;', '"')}'></slide-lab>`,
  ]
}

/** What the runners run, as JSON: a list of experiments, or the experiment if there is but one. */
export function toJson(state: LabState): string {
  const experiments = experimentsOf(state)
  return JSON.stringify(experiments.length > 1 ? experiments : experiments[0], null, 2)
}

/** A name for a file of what a lab shows, of letters that every system takes. */
export function fileName(state: LabState, ending: string): string {
  const address = writeAddress(state).replace(/^scene=[^&]*/, '')
  const words = `any-frame-rate ${state.scene} ${address}`.replace(/[^a-z0-9.]+/gi, '-')
  return `${words.slice(0, 80).replace(/[-.]+$/, '')}.${ending}`
}

function experimentsOf(state: LabState): Experiment[] {
  return state.runners.map((runner) => experimentOf(state, runner))
}

/** An experiment without what it would have anyway. */
function brief({ scene, parameters, ...others }: Experiment): Experiment {
  const usual = parseExperiment({ scene })
  return {
    scene,
    parameters: different(parameters ?? {}, usual.parameters),
    ...different(others, usual),
  }
}

function different<Options extends object>(options: Options, usual: object): Partial<Options> {
  const known = new Map(Object.entries(usual))
  const isOther = ([name, value]: [string, unknown]) =>
    JSON.stringify(value) !== JSON.stringify(known.get(name))
  return Object.fromEntries(Object.entries(options).filter(isOther)) as Partial<Options>
}

function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;')
}

/** How a table is written: what stands between its cells, and within its numbers. */
export interface CsvStyle {
  readonly separator: ',' | ';'
  readonly decimal: string
}

/**
 * The trajectories of some runners as separated values: a header with units, then a row for every frame of each runner.
 * Numbers are written in full, so that the same bits are read back.
 */
export function toCsv(
  runners: readonly SimulatedRunner[],
  exact: ExactMotion,
  { separator, decimal }: CsvStyle = { separator: ',', decimal: '.' },
): string {
  const cell = (value: string | number) =>
    typeof value === 'number' ? String(value).replace('.', decimal) : quoted(value)
  const lines = [columns.map(([heading]) => quoted(heading)).join(separator)]
  for (const runner of runners)
    for (let row = 0; row <= runner.trajectory.frames; row++)
      lines.push(columns.map(([, value]) => cell(value(runner, row, exact))).join(separator))
  // Line ends as RFC 4180 has them.
  return lines.join('\r\n') + '\r\n'
}

type ColumnValue = (runner: SimulatedRunner, row: number, exact: ExactMotion) => string | number

const columns: readonly (readonly [string, ColumnValue])[] = [
  ['runner', ({ name }) => name],
  ['frame', (_, row) => row],
  ['time (s)', ({ trajectory }, row) => trajectory.time[row]!],
  ['state time (s)', ({ trajectory }, row) => trajectory.stateTime[row]!],
  ['s (m)', ({ trajectory }, row) => trajectory.s[row]!],
  ['v (m/s)', ({ trajectory }, row) => trajectory.v[row]!],
  ['drawn s (m)', ({ trajectory }, row) => trajectory.drawnS[row]!],
  ['exact s (m)', ({ trajectory }, row, exact) => exact(trajectory.time[row]!, { s: 0, v: 0 }).s],
  ['error (m)', ({ trajectory }, row, exact) => errorAt(trajectory, exact, row)],
  ['heat (J)', ({ trajectory }, row) => trajectory.heat[row]!],
]

function quoted(text: string): string {
  return /[",;\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}
