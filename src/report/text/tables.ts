import { integrators, scenes } from '../../physics/index.ts'
import { engines as physicsEngines } from '../engines/index.ts'
import type { FrameTime, Report } from '../schema/index.ts'
import { eachInMetres, inMetres, nanoseconds, plainNumber, asMultiple } from './numbers.ts'

/** A table of the report: shown in `docs/benchmarks.md` and on the terminal. */
export interface Table {
  readonly title: string
  readonly head: readonly string[]
  readonly rows: readonly (readonly string[])[]
}

/** Errors of all engines, a column for each scene, at a slow and at the usual frame rate. */
export function engineErrors(
  { engines, engineTests }: Report,
  clocks = ['10 fps', '60 fps'],
): Table {
  const { scenes, runs } = engineTests
  return {
    title: `Error at the end, at ${clocks.join(' and at ')}`,
    head: ['', ...scenes.map(({ label }) => label)],
    rows: engines
      .filter(({ id }) => runs.some(({ engine }) => engine === id))
      .map(({ id, label }) => [
        label,
        ...scenes.map((scene) =>
          eachInMetres(
            clocks.flatMap((clock) =>
              runs
                .filter((run) => run.engine === id && run.scene === scene.id && run.clock === clock)
                .map(({ error }) => error),
            ),
          ),
        ),
      ]),
  }
}

/** What a step of each engine costs, and the friction that it really has. */
export function engineTimes(report: Report): Table {
  const { times: rows, friction } = report.engineTests
  return {
    title: 'Time of a step: one block slides down one ramp, one call a step',
    head: ['', 'time', 'quickest to slowest round', 'times ours', 'heap a step', 'μ seen for 0.5'],
    rows: rows.map(({ engine, step, ratio, bytes }) => {
      const seen = friction.find((row) => row.engine === engine)?.seen
      return [
        labelOf(report, engine),
        nanoseconds(step.median),
        `${nanoseconds(step.least)} – ${nanoseconds(step.most)}`,
        asMultiple(ratio),
        `${plainNumber(Math.round(bytes))} B`,
        seen === undefined ? '0.5' : seen.toFixed(2),
      ]
    }),
  }
}

/** Who gets to an error at the lowest cost for a simulated second. */
export function cheapestWays({ frontiers }: Report): Table {
  return {
    title: 'The cheapest way to an error: cost of one simulated second',
    head: ['', 'fewest evaluations of ours', 'odex', 'least time of ours', 'odex', 'who is ahead'],
    rows: frontiers.flatMap(({ label, at }) =>
      at.map(({ error, fewest, quickest, odex }) => [
        `${label}, ${inMetres(error)}`,
        fewest ? `${plainNumber(fewest.evaluations)} (${fewest.label})` : '–',
        odex ? plainNumber(odex.evaluations) : '–',
        quickest ? `${nanoseconds(quickest.time)} (${quickest.label})` : '–',
        odex ? nanoseconds(odex.time) : '–',
        [
          ahead('evaluations', fewest?.evaluations, odex?.evaluations),
          ahead('time', quickest?.time, odex?.time),
        ].join('; '),
      ]),
    ),
  }
}

/** What methods that choose their own steps spend on an error. */
export function controlledWays({ controlled }: Report): Table {
  return {
    title: 'Steps of their own choice: evaluations for one simulated second',
    head: ['', 'ours, to tolerance', 'odex', 'who is ahead'],
    rows: controlled.flatMap(({ label, at }) =>
      at.map(({ error, ours, odex }) => [
        `${label}, ${inMetres(error)}`,
        ours ? `${plainNumber(ours.evaluations)} (${ours.label})` : '–',
        odex === null ? '–' : plainNumber(odex),
        ahead('evaluations', ours?.evaluations, odex ?? undefined).replace('evaluations: ', ''),
      ]),
    ),
  }
}

function ahead(what: string, own: number | undefined, odex: number | undefined): string {
  if (own === undefined || odex === undefined)
    return `${what}: ${own === undefined ? (odex === undefined ? 'nobody gets there' : 'odex') : 'ours'}`
  return own <= odex
    ? `${what}: ours, ${asMultiple(odex / own)}`
    : `${what}: odex, ${asMultiple(own / odex)}`
}

/** What a call of `run.frame` costs beside the handwritten loop, a row for each scene and method that has one. */
export function frameTable({ frames }: Report): Table {
  const cell = (time: FrameTime['mixed'], ratio: number | null) =>
    time && ratio ? `${nanoseconds(time.median)}, ${asMultiple(ratio)}` : '–'
  return {
    title: 'Time of a step: run.frame, and its ratio to the handwritten loop',
    head: ['', 'handwritten loop', 'run.frame, alone', 'run.frame, after everything else'],
    rows: frames.map(({ scene, integrator, handwritten, alone, mixed, ratios }) => [
      `${labelIn(scenes, scene)}, ${labelIn(integrators, integrator)}`,
      nanoseconds(handwritten.median),
      cell(alone, ratios.alone),
      cell(mixed, ratios.mixed),
    ]),
  }
}

/** What was asked for, and what came out. */
export function targetTable({ targets }: Report): Table {
  return {
    title: 'Targets',
    head: ['', 'asked for', 'measured', '', 'where'],
    rows: targets.map(({ label, sense, limit, figure, met, from }) => [
      label,
      `${sense} ${plainNumber(limit)}`,
      plainNumber(figure),
      met ? 'met' : 'missed',
      from,
    ]),
  }
}

/** Anomalies: a line for each engine and scene, the first odd run and under which clocks others are. */
export function oddities(report: Report): string[] {
  const { runs, scenes } = report.engineTests
  const lines = new Map<string, string[]>()
  for (const { engine, scene, clock, note } of runs) {
    if (note === null) continue
    const where = `${labelOf(report, engine)}, ${scenes.find(({ id }) => id === scene)!.label}`
    const line = lines.get(where)
    if (line) line.push(clock)
    else lines.set(where, [`${note} (${clock})`])
  }
  return [...lines].map(([where, [first, ...others]]) => {
    const also = others.length > 0 ? `; also: ${others.join(', ')}` : ''
    return `${where}: ${first!}${also}`
  })
}

/** When and on what. */
export function measuredOn({ machine, engines }: Report): string {
  const { date, processor, cores, node, v8, rounds } = machine
  const versions = engines
    .filter(({ id }) => id === 'odex' || physicsEngines.some((engine) => engine.id === id))
    .map(({ label, version }) => `${label} ${version}`)
  return `Measured on ${date.slice(0, 10)} on ${cores} cores of ${processor} with Node ${node} (V8 ${v8}); times are medians of ${rounds} rounds. ${versions.join(', ')}.`
}

function labelOf({ engines }: Report, engine: string): string {
  return labelIn(engines, engine)
}

function labelIn(list: readonly { id: string; label: string }[], id: string): string {
  return list.find((each) => each.id === id)?.label ?? id
}
