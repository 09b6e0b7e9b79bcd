import { ExperimentError, frameClocks, parseExperiment } from '../physics/index.ts'
import type { FramesChoice } from '../physics/index.ts'
import { FramesUntil } from '../physics/framesUntil.ts'
import { spreadClocks } from './spreadTable.ts'

/** What a game says of itself at the end: a number, or several by name, such as `{ x, y }`. */
export type Reading<Read> = number | { readonly [Name in keyof Read]: number }

/** Anything that moves by a step of its own. */
export interface GameToMeasure<Game, Read extends Reading<Read>> {
  /** Makes the game as it is at time 0. It is called once for each clock, and must start alike each time. */
  start(): Game
  /** Moves the game by one frame of `dt` seconds, as its own loop would. */
  frame(game: NoInfer<Game>, dt: number): void
  /** What is compared at the end. */
  read(game: NoInfer<Game>): Read
  /** How long each run lasts [s]. */
  readonly duration: number
  /** The frames that are compared: two clocks or more. Without them, the eleven of the lab's spread table. */
  readonly clocks?: readonly FramesChoice[]
}

/** How a run under one clock ended. */
export interface GameEnd<Read> {
  readonly clock: FramesChoice
  /** The clock in words, as “30 fps” or “60 fps, hitches”. */
  readonly name: string
  readonly end: Read
}

/** How far apart a game ends under different frames. */
export interface GameSpread<Read> {
  /**
   * The largest difference between two ends, of all the numbers that `read` gives, in their own unit; NaN where one of
   * them is not finite, which no limit allows.
   */
  readonly spread: number
  readonly ends: readonly GameEnd<Read>[]
  /** The worst pair in a sentence, fit for a failing assertion. */
  readonly sentence: string
}

/**
 * The frame-rate spread of a game: runs it from start to end under each clock, and compares the ends.
 *
 * @throws ExperimentError for a clock or a duration that can't be run
 * @throws TypeError where `read` gives anything but numbers
 */
export function frameRateSpread<Game, const Read extends Reading<Read>>({
  start,
  frame,
  read,
  duration,
  clocks = spreadClocks,
}: GameToMeasure<Game, Read>): GameSpread<Read> {
  if (clocks.length < 2)
    throw new RangeError(`clocks has ${clocks.length} of them, but it takes two to compare`)
  const runs = clocks.map((clock, i) => checked(clock, duration, `clocks[${i}]`))
  const ends = runs.map((run) => {
    const game = start()
    const frames = new FramesUntil(run)
    while (frames.next()) frame(game, frames.delta)
    const end = read(game)
    // A game may go on writing to the object that it gave.
    return { clock: run.frames, name: nameOf(run.frames), end: copied(end) }
  })
  return { ends, ...worst(ends.map(({ name, end }) => ({ name, numbers: numbersOf(end) }))) }
}

/** The clock with nothing left out. The laboratory's own check reads it, in an experiment that is otherwise at rest. */
function checked(frames: FramesChoice, duration: number, path: string) {
  try {
    return parseExperiment({ scene: 'ramp', frames, duration })
  } catch (error) {
    if (!(error instanceof ExperimentError)) throw error
    throw new ExperimentError(
      error.problems.map((problem) => ({
        ...problem,
        path: problem.path.replace(/^frames/, path),
      })),
    )
  }
}

function nameOf(frames: FramesChoice): string {
  const label = frameClocks.find(({ id }) => id === frames.kind)!.label.toLowerCase()
  const delta = frames.delta ? `, ${frames.delta} delta` : ''
  if (!('fps' in frames)) return `${label} frames${delta}`
  return `${frames.fps} fps${frames.kind === 'steady' ? '' : `, ${label}`}${delta}`
}

function copied<Read>(end: Read): Read {
  return typeof end === 'object' && end !== null ? ({ ...end } as Read) : end
}

/** The numbers of a reading by name; a single number has no name. */
function numbersOf(end: unknown): ReadonlyMap<string, number> {
  const isObject = typeof end === 'object' && end !== null
  const entries: [string, unknown][] = isObject ? Object.entries(end) : [['', end]]
  const wrong = entries.find(([, value]) => typeof value !== 'number')
  if (wrong || entries.length === 0) {
    const [name, value] = wrong ?? ['', 'an empty object']
    throw new TypeError(
      `read gives ${String(value)}${name && ` for ${name}`}; it must give a number, or an object of numbers`,
    )
  }
  return new Map(entries as [string, number][])
}

interface NamedEnd {
  readonly name: string
  readonly numbers: ReadonlyMap<string, number>
}

/** The largest difference, and the sentence on it. */
function worst(ends: readonly NamedEnd[]): { spread: number; sentence: string } {
  let spread = 0
  let sentence = `All ${ends.length} runs end alike.`
  for (const name of new Set(ends.flatMap(({ numbers }) => [...numbers.keys()]))) {
    const subject = name || 'The game'
    const values = ends.map((end) => ({
      under: end.name,
      value: end.numbers.get(name) ?? NaN,
    }))
    const lost = values.find(({ value }) => !Number.isFinite(value))
    if (lost) return { spread: NaN, sentence: `${subject} ends at ${lost.value} (${lost.under}).` }
    values.sort((a, b) => a.value - b.value)
    const [least, most] = [values[0]!, values.at(-1)!]
    const apart = most.value - least.value
    if (apart <= spread) continue
    spread = apart
    // Three digits of the difference, and as much of both values.
    const decimals = Math.min(20, Math.max(0, 2 - Math.floor(Math.log10(apart))))
    const written = [least, most].map(({ value, under }) => `${value.toFixed(decimals)} (${under})`)
    sentence = `${subject} ends ${apart.toFixed(decimals)} apart: ${written.join(' and ')}.`
  }
  return { spread, sentence }
}
