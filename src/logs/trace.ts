import { LogError } from './logError.ts'
import { Series } from './series.ts'
import type { Candidate } from './series.ts'

/** An event of a trace, as far as it is looked at here. */
interface TraceEvent {
  readonly name?: unknown
  /** Its phase: `B` and `E`, `b` and `e` for the two ends of a stretch, `M` for a name of a thread, … */
  readonly ph?: unknown
  /** When it was [µs]. */
  readonly ts?: unknown
  readonly pid?: unknown
  readonly tid?: unknown
  readonly args?: { readonly name?: unknown } | null
}

/** What happens once a frame on a thread, what puts a picture on the screen first. */
const EVENTS = ['DrawFrame', 'AnimationFrame', 'BeginMainThreadFrame', 'BeginFrame']
/** The ends of stretches, whose beginnings count. */
const ENDS = ['E', 'e', 'F', 'f']
/** The threads with the most of them. */
const MOST_THREADS = 12

/** The events of a trace in the format of Chrome: the whole value, or its `traceEvents`; undefined for anything else. */
export function eventsIn(value: unknown): readonly TraceEvent[] | undefined {
  const isObject = typeof value === 'object' && value !== null
  const list: unknown = isObject && 'traceEvents' in value ? value.traceEvents : value
  const isTrace = Array.isArray(list) && list.some((each) => isEvent(each) && 'ph' in each)
  return isTrace ? list.filter(isEvent) : undefined
}

function isEvent(value: unknown): value is TraceEvent {
  return typeof value === 'object' && value !== null
}

/** Reads the instants of frames, thread by thread; yields now and then, so that the caller can pause. */
export function* readTrace(events: readonly TraceEvent[]): Generator<number, Candidate[]> {
  /** By thread: the instants of each kind of event. */
  const threads = new Map<string, number[][]>()
  const names = new Map<string, string>()
  for (const [i, { name, ph, ts, pid, tid, args }] of events.entries()) {
    if (i % 20_000 === 0) yield i / events.length
    const thread = `${String(tid)} of process ${String(pid)}`
    if (ph === 'M' && name === 'thread_name') names.set(thread, String(args?.name))
    if (typeof ts !== 'number' || !EVENTS.includes(String(name)) || ENDS.includes(String(ph)))
      continue
    const instants = threads.get(thread) ?? emptied()
    threads.set(thread, instants)
    instants[EVENTS.indexOf(String(name))]!.push(ts)
  }
  const rows = (instants: readonly number[][]) => instants.flat().length
  const most = [...threads].sort(([, a], [, b]) => rows(b) - rows(a)).slice(0, MOST_THREADS)
  if (most.length === 0)
    throw new LogError(`This trace holds no event of a frame: ${EVENTS.join(', ')}.`)
  const candidates: Candidate[] = []
  for (const [thread, instants] of most)
    for (const [i, name] of EVENTS.entries()) {
      const series = new Series('Event')
      // Threads write into a trace when they get to it, not in the order of time.
      const sorted = instants[i]!.sort((a, b) => a - b)
      sorted.forEach((each, k) => series.add(String(each), k + 1))
      const process = `${names.get(thread) ?? 'Thread'} ${thread}`
      const meaning = { rank: 0, isClock: true }
      candidates.push(yield* series.candidate(name, process, meaning, 'µs'))
    }
  return candidates
}

function emptied(): number[][] {
  return EVENTS.map(() => [])
}
