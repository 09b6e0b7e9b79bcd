import type { Actor } from './actors.ts'
import { top } from './body.ts'
import { clamp } from '../chart/geometry.ts'
import type { Placed } from './labels.ts'
import type { Layout } from './layout.ts'
import { place, seconds } from '../chart/numbers.ts'
import type { Picture } from './picture.ts'
import { widthOf } from '../chart/text.ts'

/** More labels than this say only whose they are. */
const WORDY = 4
/** For the mark in front of a name. */
export const MARK = 14
/** For the flag of a block that rests, with and without its time. */
const FLAG = 15
const words = { 'at-rest': '', 'left-the-track': 'left the track', diverged: 'diverged' }

/** What stands next to a block: whose it is, where it is, and since when it rests. */
export interface Caption {
  readonly actor: Actor
  /** The context's. */
  readonly font: string
  readonly text: string
  readonly time: string
  /** How wide the mark and the text are. */
  readonly name: number
  /** Of the flag and its time, if there will be one. */
  readonly flag: number
  /** Of all, the flag's room included, so that nothing moves when it is hoisted. */
  readonly width: number
  readonly lean: number
  /** Where its pole stands [px]. */
  readonly pole: number
}

/** What to write at an actor, in the context's font. */
export function captionOf(
  context: CanvasRenderingContext2D,
  font: string,
  actor: Actor,
  { runners }: Picture,
  { camera, width: canvas }: Layout,
): Caption {
  const { runner, end, distance, body } = actor
  const wordy = runners.length <= WORDY
  const ending = end ? words[end.kind] : ''
  const where = ending || (wordy ? place(distance, 5 / camera.scale) : '')
  const text = [runner ? runner.name : 'exact', where].filter(Boolean).join(' · ')
  const time = wordy && end?.kind === 'at-rest' ? seconds(end.time) : ''
  const pole = top(body).x
  const name = widthOf(context, text, font) + (runner ? MARK : 0)
  const { restsAt } = actor
  const stamps = ['0.00 s', restsAt === undefined ? '' : seconds(restsAt)]
  const stamp = Math.max(...stamps.map((each) => widthOf(context, each, font)))
  const flag = restsAt === undefined ? 0 : FLAG + (wordy ? 8 + stamp : 0)
  const lean = leanAt(body.spot.descent, pole, name)
  // Near the canvas's edge, where a flag would push its label over the pole, its room is not kept free, nor on a
  // canvas that has none to spare.
  const room = lean < 1 ? flag : clamp(pole - name - 12, 0, flag)
  // Hoisted there all the same, it hangs on the other side of the pole, without its time.
  const cramped = end !== undefined && room < flag
  const free = canvas < 480 && !end ? 0 : room
  const width = cramped ? Math.max(name, pole) + FLAG : name + free
  const shown = cramped ? '' : time
  return { actor, font, text, name, time: shown, flag: cramped ? FLAG : flag, width, lean, pole }
}

/** Where the name and the flag begin in a caption's box; neither ever leaves it. */
export function partsOf(
  { name, flag, width, lean, pole }: Caption,
  { left, aside }: Placed,
): { name: number; flag: number } {
  if (aside || lean <= 0.5) return { name: left, flag: left + name + 6 }
  const end = left + width - name
  // A name keeps to its pole, also where the canvas's edge has pushed the label; the flag takes what is left.
  const start = lean < 1 ? end : clamp(pole - name - 6, left, end)
  const isRoomy = start - left > flag - 1
  return { name: start, flag: isRoomy ? left + 2 : Math.max(start + name, pole) + 6 }
}

/**
 * A label hangs over the side on which the ground falls away, and over level ground to the left; but to the right
 * where there is no room for it.
 */
function leanAt(descent: number, pole: number, width: number): number {
  const room = clamp((pole - 0.85 * width) / (0.15 * width + 12), 0, 1)
  // Over ground that rises steeply to the right there is even less.
  const wall = clamp((-descent - 0.35) / 0.1, 0, 1)
  return Math.min(Math.max(room, wall), 1 - clamp(descent / 0.25, 0, 1))
}
