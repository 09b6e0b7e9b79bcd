import { LogError } from './logError.ts'
import { Series } from './series.ts'
import type { Candidate } from './series.ts'
import { eventsIn, readTrace } from './trace.ts'

type Loose = Readonly<Record<string, unknown>>

/** What a capture of CapFrameX holds besides frame times is left aside. */
const lengths = { rank: 0, isClock: false }
const LENGTHS = ['MsBetweenPresents', 'MsBetweenDisplayChange']

/** Frame times in JSON: a trace of Chrome, a capture of CapFrameX, or a list of numbers. */
export function* readJson(text: string): Generator<number, Candidate[]> {
  const value = parsed(text)
  const events = eventsIn(value)
  if (events) return yield* readTrace(events)
  if (Array.isArray(value)) return [yield* seriesOf(value).candidate('', '', lengths)]
  const runs = isObject(value) ? value.Runs : undefined
  if (!Array.isArray(runs))
    throw new LogError(
      'This JSON holds neither a trace of Chrome, runs of CapFrameX nor a list of frame times.',
    )
  const candidates: Candidate[] = []
  for (const [i, run] of (runs as unknown[]).entries()) {
    const data = isObject(run) && isObject(run.CaptureData) ? run.CaptureData : {}
    const process = runs.length > 1 ? `Run ${i + 1}` : ''
    for (const name of LENGTHS) {
      const list = data[name]
      if (Array.isArray(list))
        candidates.push(yield* seriesOf(list).candidate(name, process, lengths))
    }
  }
  if (candidates.length === 0)
    throw new LogError('None of the runs in this JSON has a list MsBetweenPresents.')
  return candidates.sort((a, b) => b.durations.length - a.durations.length)
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text)
  } catch (error) {
    const cut = eventsIn(cutOff(text))
    if (cut) return cut
    throw new LogError(`This begins like JSON, but is none: ${(error as Error).message}`)
  }
}

/** A trace may end without its bracket, where the browser was closed. */
function cutOff(text: string): unknown {
  try {
    return JSON.parse(`${text.trimEnd().replace(/,$/, '')}]`)
  } catch {
    return undefined
  }
}

function seriesOf(list: readonly unknown[]): Series {
  const series = new Series('Value')
  list.forEach((each, i) => series.add(typeof each === 'number' ? String(each) : show(each), i + 1))
  return series
}

function show(value: unknown): string {
  return typeof value === 'object' && value !== null ? 'an object' : String(value)
}

function isObject(value: unknown): value is Loose {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}
