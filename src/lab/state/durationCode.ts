/*
 * Frame times as a short text, for links. They are whole numbers of ticks of 0.1 ms:
 *
 *     4n-m3lm2_9P
 *
 * First stands the usual frame time in ticks, in base 36 (here 167: 16.7 ms), and a hyphen. Then each letter is a frame,
 * m of the usual time, l one tick shorter, n one tick longer, and so on from a to y; a number after it says how many such
 * frames follow each other. A time that is out of reach of the letters stands in ticks after `_`, in base 36 and capitals.
 *
 * Finer times, as those of a log, are whole microseconds:
 *
 *     ~-xgBAAmB
 *
 * After `~` stand the usual frame time (here 16 671) and, for each frame, how much longer it is (0, 0, 19), as VLQ numbers
 * in base 64: from the lowest to the highest, each character has five bits of the number and a sixth that is set while more
 * follow; the lowest bit of all is the sign. It takes two or three characters a frame.
 */

const TICKS = 10_000
const MICROSECONDS = 1e6
const MIDDLE = 'm'.charCodeAt(0)
/** From m to a, or to y. */
const REACH = 12
const pattern = /^([0-9a-z]+)-((?:[a-z]\d*|_[0-9A-Z]+)+)$/
/** More than any clock takes; a text that asks for more is cut there, and refused by the clock's own check. */
const MOST = 200_000
/** The shortest frame that the clock takes [µs]. */
const SHORTEST = 10
/** All of them may stand in an address as they are. */
const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_'

/** Frame times [s] as text; undefined where they are neither whole tenths of a millisecond nor whole microseconds. */
export function writeDurations(durations: readonly number[]): string | undefined {
  const ticks = whole(durations, TICKS)
  const coarse = ticks && inLetters(ticks)
  const fine = whole(durations, MICROSECONDS)
  const packed = fine && inNumbers(fine)
  return coarse && packed && packed.length < coarse.length ? packed : (coarse ?? packed)
}

/** Frame times [s] as text, each instant rounded to the microsecond. */
export function writeRounded(durations: readonly number[]): string {
  let time = 0
  let ticks = 0
  return inNumbers(
    durations.map((duration) => {
      const before = ticks
      time += duration * MICROSECONDS
      ticks = Math.round(time)
      return Math.max(SHORTEST, ticks - before)
    }),
  )
}

/** Times as whole numbers of a fraction of a second; undefined where they are none. */
function whole(durations: readonly number[], perSecond: number): number[] | undefined {
  const ticks = durations.map((each) => Math.round(each * perSecond))
  const isWhole = (tick: number, i: number) =>
    tick >= 1 && tick < Infinity && tick / perSecond === durations[i]
  return ticks.length > 0 && ticks.every(isWhole) ? ticks : undefined
}

function median(ticks: readonly number[]): number {
  return Float64Array.from(ticks).sort()[ticks.length >> 1]!
}

function inLetters(ticks: readonly number[]): string {
  const usual = median(ticks)
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

function inNumbers(ticks: readonly number[]): string {
  const usual = median(ticks)
  return `~${vlq(usual)}${ticks.map((tick) => vlq(tick - usual)).join('')}`
}

/** A whole number; by division, since it may be longer than 32 bits. */
function vlq(value: number): string {
  let rest = value < 0 ? -2 * value + 1 : 2 * value
  let text = ''
  for (; rest >= 32; rest = Math.floor(rest / 32)) text += DIGITS[32 + (rest % 32)]!
  return text + DIGITS[rest]!
}

/** A letter so often, in the shorter way. */
function letters(letter: string, run: number): string {
  return run > 2 ? letter + String(run) : letter.repeat(run)
}

/** The frame times [s] that such a text stands for; undefined where it is none. */
export function readDurations(text: string): number[] | undefined {
  return text.startsWith('~') ? readNumbers(text) : readLetters(text)
}

function readNumbers(text: string): number[] | undefined {
  const numbers: number[] = []
  let value = 0
  let place = 1
  for (const character of text.slice(1)) {
    const digit = DIGITS.indexOf(character)
    if (digit < 0) return undefined
    value += (digit % 32) * place
    place *= 32
    if (digit >= 32) continue
    numbers.push(value % 2 === 0 ? value / 2 : -(value - 1) / 2)
    value = 0
    place = 1
  }
  // A number that is cut off is none.
  if (place > 1 || numbers.length < 2) return undefined
  const [usual, ...longer] = numbers as [number, ...number[]]
  return longer.map((each) => (usual + each) / MICROSECONDS)
}

function readLetters(text: string): number[] | undefined {
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
