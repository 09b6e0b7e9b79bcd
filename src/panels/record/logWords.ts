import { count, fixed, plain } from '../../chart/numbers.ts'
import type { Candidate } from '../../logs/index.ts'

/** Frames one after the other, with what is asked of them again and again. */
export interface LogStretch {
  readonly durations: Float64Array
  /** When each of them begins, and when the last ends [s]. */
  readonly instants: Float64Array
}

export function stretchOf(durations: Float64Array): LogStretch {
  const instants = new Float64Array(durations.length + 1)
  durations.forEach((duration, i) => (instants[i + 1] = instants[i]! + duration))
  return { durations, instants }
}

/** The frames that begin at `from` or later and before `to` [s], and no more than so many. */
export function framesBetween(
  { durations, instants }: LogStretch,
  from: number,
  to: number,
  most: number,
): Float64Array {
  // The last instant begins no frame.
  const first = Math.min(placeOf(instants, from), durations.length - 1)
  const end = Math.min(Math.max(placeOf(instants, to), first + 1), first + most, durations.length)
  return durations.subarray(first, end)
}

/** The first of the rising instants that is at `time` or later, to half a microsecond. */
function placeOf(instants: Float64Array, time: number): number {
  let [low, high] = [0, instants.length]
  while (low < high) {
    const middle = (low + high) >> 1
    if (instants[middle]! < time - 5e-7) low = middle + 1
    else high = middle
  }
  return low
}

/** “4 265 frames in 30.0 s, median 6.9 ms, longest 131 ms, from msBetweenPresents (in ms); 3 rows left out”. */
export function logSummary(
  frames: Float64Array,
  { column, unit, isClock, leftOut }: Pick<Candidate, 'column' | 'unit' | 'isClock' | 'leftOut'>,
): string {
  const sorted = frames.slice().sort()
  const total = frames.reduce((sum, each) => sum + each, 0)
  const times = `median ${ms(sorted[(sorted.length - 1) >> 1]!)}, longest ${ms(sorted[sorted.length - 1]!)}`
  const differences = isClock ? 'the differences of ' : ''
  const source = column ? `${differences}${column} (in ${unit})` : `a list in ${unit}`
  const rest = leftOut > 0 ? `; ${rows(leftOut)} left out` : ''
  return `${some(frames.length, 'frame')} in ${total < 0.1 ? ms(total) : `${fixed(total, 1)} s`}, ${times}, from ${source}${rest}`
}

/** “3 rows”. */
export function rows(number: number): string {
  return some(number, 'row')
}

function some(number: number, noun: string): string {
  return `${count(number)} ${noun}${number === 1 ? '' : 's'}`
}

function ms(seconds: number): string {
  const milliseconds = seconds * 1000
  const text = milliseconds < 99.95 ? fixed(milliseconds, 1) : count(Math.round(milliseconds))
  return `${milliseconds < 0.95 ? plain(milliseconds) : text} ms`
}
