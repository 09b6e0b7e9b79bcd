/*
 * Frame times as a short text, for links. They are whole numbers of ticks of 0.1 ms:
 *
 *     4n-m3lm2_9P
 *
 * First stands the usual frame time in ticks, in base 36 (here 167: 16.7 ms), and a hyphen. Then each letter is a frame,
 * m of the usual time, l one tick shorter, n one tick longer, and so on from a to y; a number after it says how many such
 * frames follow each other. A time that is out of reach of the letters stands in ticks after `_`, in base 36 and capitals.
 */

const TICKS = 10_000
const MIDDLE = 'm'.charCodeAt(0)
/** From m to a, or to y. */
const REACH = 12
const pattern = /^([0-9a-z]+)-((?:[a-z]\d*|_[0-9A-Z]+)+)$/
/** More than any clock takes; a text that asks for more is cut there, and refused by the clock's own check. */
const MOST = 100_000

/** Frame times [s] as text; undefined where they are not whole tenths of a millisecond. */
export function writeDurations(durations: readonly number[]): string | undefined {
  const ticks = durations.map((each) => Math.round(each * TICKS))
  if (
    ticks.length === 0 ||
    ticks.some((tick, i) => !(tick >= 1 && tick < Infinity && tick / TICKS === durations[i]))
  )
    return undefined
  const usual = [...ticks].sort((a, b) => a - b)[ticks.length >> 1]!
  let text = `${usual.toString(36)}-`
  for (let i = 0; i < ticks.length;) {
    const tick = ticks[i]!
    let run = 1
    while (ticks[i + run] === tick) run++
    if (Math.abs(tick - usual) > REACH) text += `_${tick.toString(36).toUpperCase()}`.repeat(run)
    else text += letters(String.fromCharCode(MIDDLE + tick - usual), run)
    i += run
  }
  return text
}

/** A letter so often, in the shorter way. */
function letters(letter: string, run: number): string {
  return run > 2 ? letter + String(run) : letter.repeat(run)
}

/** The frame times [s] that such a text stands for; undefined where it is none. */
export function readDurations(text: string): number[] | undefined {
  const [, first, rest] = pattern.exec(text) ?? []
  if (first === undefined || rest === undefined) return undefined
  const usual = parseInt(first, 36)
  const durations: number[] = []
  for (const [item, letter, times, other] of rest.matchAll(/([a-z])(\d*)|_([0-9A-Z]+)/g)) {
    const tick = other ? parseInt(other, 36) : usual + item.charCodeAt(0) - MIDDLE
    const room = MOST - durations.length
    const run = letter && times ? Math.min(Number(times), room) : 1
    for (let i = 0; i < run; i++) durations.push(tick / TICKS)
  }
  return durations
}
