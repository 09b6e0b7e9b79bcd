/** What a log counts time in. */
export type Unit = 's' | 'ms' | 'µs' | 'ns'

/** How many of a unit make a second. */
export const perSecond: Readonly<Record<Unit, number>> = { s: 1, ms: 1e3, µs: 1e6, ns: 1e9 }

export const units = Object.keys(perSecond) as readonly Unit[]

/** The unit that a column's heading names, as in `msBetweenPresents`, `Time (ms)`, `frame_time_us`, `TimeInSeconds`. */
export function unitNamed(heading: string): Unit | undefined {
  const [, bracketed] = /[([]\s*([a-zµμ]+)\.?\s*[)\]]/i.exec(heading) ?? []
  const word =
    bracketed ??
    /^(ms)(?=[A-Z_ ]|between)/i.exec(heading)?.[1] ??
    /[_ ](ns|us|µs|μs|ms|s|sec|seconds)$/i.exec(heading)?.[1] ??
    /(?:In|_)(Seconds|Milliseconds|Microseconds)$/i.exec(heading)?.[1] ??
    /[a-z](Ns|Us|Ms)$/.exec(heading)?.[1]
  return word === undefined ? undefined : spelled[word.toLowerCase()]
}

const spelled: Readonly<Record<string, Unit>> = {
  ...{ s: 's', sec: 's', secs: 's', second: 's', seconds: 's' },
  ...{ ms: 'ms', msec: 'ms', milliseconds: 'ms' },
  // The micro sign and the Greek letter look alike.
  ...{ us: 'µs', µs: 'µs', μs: 'µs', microseconds: 'µs', ns: 'ns', nanoseconds: 'ns' },
}

/** The unit in which a usual frame time is such a number: games draw between 1 and 1000 frames a second. */
export function unitBySize(median: number): Unit {
  if (median < 1) return 's'
  if (median <= 1000) return 'ms'
  return median <= 1e6 ? 'µs' : 'ns'
}
