import type { Timing } from '../schema/index.ts'

/**
 * Something whose time is taken: `prepare` is not counted, `run` is; its result is used, so that the compiler can't
 * remove it.
 */
export interface TimedWork {
  /** How many units of work a run is: times are given for one of them. */
  readonly units: number
  prepare?(): void
  run(): number
}

/** How carefully times are taken. */
export interface Care {
  readonly rounds: number
  /** A work is repeated in each round for so long [ms]: short, so that some rounds meet no other program. */
  readonly atLeast: number
  /** A work is repeated for so long before the rounds [ms]: by then the engine has compiled what it calls. */
  readonly warming: number
}

let used = 0

/**
 * The processor time of each work for a unit [ns], a number for each round. Rounds are interleaved, work after work, so that
 * whatever else the machine does hits all of them alike.
 */
export function timeRounds(
  works: readonly TimedWork[],
  { rounds, atLeast, warming }: Care,
): number[][] {
  const times = works.map((): number[] => [])
  for (const work of works) timeOnce(work, warming)
  for (let round = 0; round < rounds; round++)
    for (const [i, work] of inTurn(works, round)) times[i]!.push(timeOnce(work, atLeast))
  if (Number.isNaN(used)) throw new Error('A work that was timed came to no number.')
  return times
}

/** Every other round runs backwards, so that no work always follows the same one. */
function inTurn(works: readonly TimedWork[], round: number): [number, TimedWork][] {
  const entries = [...works.entries()]
  return round % 2 === 0 ? entries : entries.reverse()
}

function timeOnce(work: TimedWork, atLeast: number): number {
  let elapsed = 0
  let runs = 0
  while (elapsed < atLeast) {
    work.prepare?.()
    const start = process.cpuUsage()
    used += work.run()
    const { user, system } = process.cpuUsage(start)
    elapsed += (user + system) / 1000
    runs++
  }
  return (elapsed * 1e6) / (runs * work.units)
}

/** The middle of some numbers. */
export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b)
  const middle = sorted.length >> 1
  return sorted.length % 2 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2
}

/** Median and spread of the rounds. */
export function timingOf(rounds: readonly number[]): Timing {
  return { median: median(rounds), least: Math.min(...rounds), most: Math.max(...rounds) }
}

/** The median of one work's time divided by another's, each from the same round. */
export function ratioOf(rounds: readonly number[], to: readonly number[]): number {
  return median(rounds.map((time, round) => time / to[round]!))
}
