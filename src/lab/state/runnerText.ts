import { engines } from '../../engines/index.ts'
import {
  defaults,
  frameClocks,
  integrators,
  measuring,
  stoppings,
  timesteps,
} from '../../physics/index.ts'
import type { Option, Options, Problem } from '../../physics/index.ts'
import { writeNumber } from '../../chart/numbers.ts'
import { readNumber } from '../../chart/typedNumber.ts'
import { MOST_RUNNERS } from './check.ts'
import type { DraftRunner } from './check.ts'
import { readDurations, writeDurations, writeRounded } from './durationCode.ts'
import type { RunnerState } from './state.ts'

/*
 * Runners as text: one after the other with `;` between, each a row of words with `/` between:
 *
 *     10;30/semi-implicit-euler/clamped;jitter(fps:30,amount:0.5,seed:1)/fixed(step:1/60)/rk4
 *
 * A number is a steady frame rate that is measured exactly. Any other word is the id of a frame clock, a timestep, an
 * integrator or a stopping rule, with its options in brackets; the items of a list stand with `+` between, or as
 * durationCode.ts writes them where that is shorter. The id of an engine stands for its timestep, integrator and stopping
 * rule. `hidden` hides the runner, `look(3)` gives it the fourth colour instead of its turn's. What is left out is at the
 * default of an experiment, so the example begins with velocity Verlet, located stops and a variable step at 10 fps.
 */

/** A list may take so much of an address as it stands [characters]. */
const LONG = 10_000

/** Runners as text. */
export function writeRunners(runners: readonly RunnerState[]): string {
  return runners.map(writeRunner).join(';')
}

/** The runners that a text stands for, as yet unchecked. What can't be read at all is added to the problems. */
export function readRunners(text: string, problems: Problem[]): DraftRunner[] {
  const texts = split(text, ';')
  const runners = texts.slice(0, MOST_RUNNERS).map((runner, i) => readRunner(runner, i, problems))
  // Those that are too many count, and are not read.
  return texts.map((_, i) => runners[Math.min(i, MOST_RUNNERS - 1)]!)
}

function writeRunner(runner: RunnerState, turn: number): string {
  const { frames, paletteIndex, hidden } = runner
  const words = [
    frames.kind === 'steady' && !frames.delta
      ? writeNumber(frames.fps)
      : call(frames, frameClocks, measuring),
  ]
  const engine = engines.find(({ label }) => label === runner.engine)
  words.push(...(engine ? [engine.id] : writeMethod(runner)))
  if (paletteIndex !== turn) words.push(`look(${paletteIndex})`)
  if (hidden) words.push('hidden')
  return words.join('/')
}

function writeMethod({ timestep, integrator, stopping }: RunnerState): string[] {
  const words: string[] = []
  if (timestep.kind !== defaults.timestep.kind) words.push(call(timestep, timesteps))
  if (integrator !== defaults.integrator) words.push(integrator)
  if (stopping !== defaults.stopping) words.push(stopping)
  return words
}

/**
 * An entry of a list with its options, as `fixed(step:1/60)`. Options that can be left out and are as they begin are.
 */
function call(
  chosen: RunnerState['frames'] | RunnerState['timestep'],
  list: readonly { readonly id: string; readonly options: Options }[],
  common: Options = {},
): string {
  const { kind, ...values } = chosen
  const options = { ...list.find(({ id }) => id === kind)!.options, ...common }
  const given = Object.entries(values)
    .filter(([key, value]) => !(options[key]!.optional && options[key]!.initial === value))
    .map(([key, value]) => `${key}:${writeValue(value)}`)
  return given.length > 0 ? `${kind}(${given.join(',')})` : kind
}

function writeValue(value: unknown): string {
  if (Array.isArray(value)) return writeList(value as number[])
  return typeof value === 'number' ? writeNumber(value) : String(value)
}

/** Lists as text: the same ones are written at every change of anything else. */
const written = new WeakMap<readonly number[], string>()

/** As exact as it is where that takes no more room; otherwise its times are rounded to a microsecond. */
function writeList(list: readonly number[]): string {
  const known = written.get(list)
  if (known !== undefined) return known
  const plain = list.map(writeNumber).join('+')
  const code = writeDurations(list) ?? (plain.length > LONG ? writeRounded(list) : plain)
  const text = code.length < plain.length ? code : plain
  if (Object.isFrozen(list)) written.set(list, text)
  return text
}

function readRunner(text: string, turn: number, problems: Problem[]): DraftRunner {
  const runner: Record<keyof RunnerState, unknown> = {
    ...{ frames: defaults.frames, timestep: defaults.timestep },
    ...{ integrator: defaults.integrator, stopping: defaults.stopping },
    ...{ paletteIndex: turn, hidden: false, engine: undefined },
  }
  // What is said after an engine changes it.
  const method = (values: object) => Object.assign(runner, { engine: undefined }, values)
  for (const word of split(text, '/')) {
    const [, id = word, inside] = /^([^()]*)(?:\((.*)\))?$/s.exec(word) ?? []
    const rate = readNumber(word)
    const engine = engines.find((each) => each.id === word)
    const clock = frameClocks.find((each) => each.id === id)
    const policy = timesteps.find((each) => each.id === id)
    if (rate !== undefined) runner.frames = { kind: 'steady', fps: rate }
    else if (engine) method({ ...engine.method, engine: engine.label })
    else if (clock)
      runner.frames = { kind: id, ...readOptions(inside, { ...clock.options, ...measuring }) }
    else if (policy) method({ timestep: { kind: id, ...readOptions(inside, policy.options) } })
    else if (integrators.some((each) => each.id === word)) method({ integrator: word })
    else if (stoppings.some((each) => each.id === word)) method({ stopping: word })
    else if (id === 'look' && inside) runner.paletteIndex = readNumber(inside) ?? inside
    else if (word === 'hidden') runner.hidden = true
    else problems.push({ path: `runners[${turn}]`, message: unknownWord(word) })
  }
  return runner
}

function readOptions(text = '', options: Options): Record<string, unknown> {
  const pairs = split(text, ',').filter(Boolean)
  return Object.fromEntries(
    pairs.map((pair) => {
      const [key, ...rest] = pair.split(':')
      return [key, readValue(rest.join(':'), options[key!])]
    }),
  )
}

function readValue(text: string, option: Option | undefined): unknown {
  if (option?.type === 'list')
    return readDurations(text) ?? text.split('+').map((item) => readNumber(item) ?? item)
  return option?.type === 'choice' ? text : (readNumber(text) ?? text)
}

const known = [frameClocks, timesteps, integrators, stoppings]
  .flatMap((list) => list.map(({ id }) => id))
  .join(', ')

function unknownWord(word: string): string {
  return `"${word.slice(0, 40)}" is neither a frame rate nor one of ${known}, nor an engine such as ${engines[2].id}`
}

/** Cuts at a separator that does not stand in brackets. */
function split(text: string, separator: string): string[] {
  const parts: string[] = []
  let depth = 0
  let from = 0
  for (let i = 0; i < text.length; i++) {
    const letter = text[i]
    if (letter === '(') depth++
    else if (letter === ')') depth--
    else if (letter === separator && depth <= 0) {
      parts.push(text.slice(from, i).trim())
      from = i + 1
    }
  }
  return [...parts, text.slice(from).trim()]
}
