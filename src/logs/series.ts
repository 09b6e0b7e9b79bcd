import { readCell } from './lines.ts'
import type { Meaning } from './columns.ts'
import { perSecond, unitBySize, unitNamed, units } from './units.ts'
import type { Unit } from './units.ts'

/** The shortest and the longest frame that the clock `recorded` takes [s]. */
const SHORTEST = 1e-5
const LONGEST = 60
/** So many rows are named with what is wrong with them; of the rest it is known how many there are. */
const MOST_NAMED = 100

/** A row that is no frame, and why. */
export interface LeftOut {
  /** “Line 3”, or of a JSON list “Value 3”, counted from 1. */
  readonly place: string
  readonly reason: string
}

/** Frame times that a log can be read as. */
export interface Candidate {
  /** The heading that they stand under; empty for a bare list. */
  readonly column: string
  /** Whose they are, where the log says so. */
  readonly process: string
  readonly unit: Unit
  /** Those in which its usual value is a frame that the clock takes. */
  readonly units: readonly Unit[]
  /** The same column, read in another of them. */
  readonly inUnit: (unit: Unit) => Candidate
  /** The column holds instants; these are the times between them. */
  readonly isClock: boolean
  /** How long the frames are, in whole microseconds that add up to the log's length [s]. */
  readonly durations: Float64Array
  readonly leftOut: number
  /** The first of the rows that are left out. */
  readonly reasons: readonly LeftOut[]
}

/** A column of a log, cell by cell. */
export class Series {
  private readonly values: number[] = []
  private readonly lines: number[] = []
  /** What stands where there is no number. */
  private readonly unread = new Map<number, string>()
  private readonly noun: string

  /** `noun`: what its cells are counted in. */
  constructor(noun = 'Line') {
    this.noun = noun
  }

  get rows(): number {
    return this.values.length
  }

  /** How many of its cells are numbers. */
  get numbers(): number {
    return this.values.length - this.unread.size
  }

  add(text: string, line: number): void {
    const value = readCell(text)
    if (Number.isNaN(value)) this.unread.set(this.values.length, text)
    this.values.push(value)
    this.lines.push(line)
  }

  /**
   * The frame times that the column stands for, in its unit or else in the one that its heading or its size tells; yields
   * now and then, so that the caller can pause.
   */
  *candidate(
    column: string,
    process: string,
    meaning: Meaning,
    given?: Unit,
  ): Generator<number, Candidate> {
    const { values } = this
    const isClock = meaning.isClock && this.mostlyRises()
    const usual = this.usual(isClock)
    const likely = units.filter(
      (each) => whyNot(usual / perSecond[each], undefined, isClock) === '',
    )
    const named = unitNamed(column)
    // A heading that names a unit in which no frame is possible names another thing.
    const told =
      named && (likely.includes(named) || likely.length === 0) ? named : unitBySize(usual)
    const unit = given ?? told
    const durations = new Float64Array(values.length)
    const reasons: LeftOut[] = []
    let [frames, leftOut, before, time, ticks] = [0, 0, NaN, 0, 0]
    for (let i = 0; i < values.length; i++) {
      const value = values[i]!
      const text = Number.isNaN(value) ? this.unread.get(i) : undefined
      const length = (isClock ? value - before : value) / perSecond[unit]
      const isFirst = isClock && text === undefined && Number.isNaN(before)
      // A clock that was set back, as where a second log begins, goes on from there.
      if (text === undefined) before = value
      if (isFirst) continue
      const reason = whyNot(length, text, isClock)
      if (reason) {
        if (leftOut++ < MOST_NAMED)
          reasons.push({ place: `${this.noun} ${this.lines[i]!}`, reason })
        continue
      }
      // It is the instants that are rounded, so that the lengths add up to what passed.
      time += length * 1e6
      const next = Math.round(time)
      durations[frames++] = Math.max(SHORTEST * 1e6, next - ticks) / 1e6
      ticks = next
      if (frames % 20_000 === 0) yield 1
    }
    const own = durations.slice(0, frames)
    const inUnit = (other: Unit) => whole(this.candidate(column, process, meaning, other))
    return {
      ...{ column, process, unit, units: likely, inUnit },
      ...{ isClock, durations: own, leftOut, reasons },
    }
  }

  /** The median of what is positive, of as many rows as tell its size. */
  private usual(isClock: boolean): number {
    const { values } = this
    const every = Math.ceil(values.length / 5000)
    const some: number[] = []
    for (let i = isClock ? 1 : 0; i < values.length; i += every) {
      const value = isClock ? values[i]! - values[i - 1]! : values[i]!
      if (value > 0) some.push(value)
    }
    return some.sort((a, b) => a - b)[some.length >> 1] ?? 0
  }

  /** A column named “time” may hold frame times as well as a clock: only a clock rises. */
  private mostlyRises(): boolean {
    const { values } = this
    let [rises, falls] = [0, 0]
    for (let i = 1; i < values.length; i++) {
      if (values[i]! > values[i - 1]!) rises++
      else if (values[i]! < values[i - 1]!) falls++
    }
    return rises >= 9 * falls
  }
}

/** What a generator returns, without a pause. */
function whole<T>(generator: Generator<unknown, T>): T {
  let step = generator.next()
  while (!step.done) step = generator.next()
  return step.value
}

function whyNot(length: number, text: string | undefined, isClock: boolean): string {
  if (text === '') return 'is empty'
  if (text !== undefined) return `“${text.slice(0, 20)}” is not a number`
  if (length === 0) return isClock ? 'is the same instant as the row before' : 'is 0'
  if (length < 0) return isClock ? 'is earlier than the row before' : 'is negative'
  if (length < SHORTEST) return 'is shorter than 10 µs'
  return length > LONGEST ? `is longer than ${LONGEST} s` : ''
}
