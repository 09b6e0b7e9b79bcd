import { clamp } from '../chart/geometry.ts'
import type { Box } from '../chart/geometry.ts'
import { place, seconds } from '../chart/numbers.ts'
import { widthOf, write } from '../chart/text.ts'
import type { Actor } from './actors.ts'
import { centre, top } from './body.ts'
import type { Placed } from './labels.ts'
import type { Layout } from './layout.ts'
import { markOf } from './marks.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'

/** More labels than this say only whose they are. */
const WORDY = 4
/** For the mark in front of a name. */
const MARK = 14
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
  const there = wordy ? place(distance, 5 / camera.scale) : ''
  const left = end?.kind === 'left-the-track' && there && `left at ${there}, ${seconds(end.time)}`
  const where =
    left || (runner?.trajectory.abandoned && ending ? 'tolerance not met' : ending) || there
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
function partsOf(
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

/** A caption, and where it is written. */
export interface Written {
  readonly caption: Caption
  readonly box: Placed
}

function colours({ actor: { runner } }: Caption, palette: Palette): { fill: string; text: string } {
  return runner ? palette.runners[runner.paletteIndex]! : { fill: palette.ink, text: palette.ink }
}

/** The line from a block to its label; it is broken where there are `letters`. */
export function drawLeader(
  context: CanvasRenderingContext2D,
  { caption, box }: Written,
  letters: readonly Box[],
  vertical: boolean,
  palette: Palette,
): void {
  const { body } = caption.actor
  context.strokeStyle = colours(caption, palette).text
  context.lineWidth = 1
  context.beginPath()
  if (vertical) {
    const middle = (box.top + box.bottom) / 2
    const { x, y } = centre(body)
    const side = x + body.size / 2
    context.moveTo(side, y)
    context.lineTo(Math.max(box.left - 18, side), middle)
    context.lineTo(box.left - 5, middle)
  } else {
    const { x, y } = top(body)
    context.moveTo(x, y)
    // A pole stands beside its label, or under it where the canvas's edge has pushed the label over it.
    const end = x > box.left - 3 && x < box.right + 3 ? box.bottom : box.top + 3
    for (const { left, right, top, bottom } of letters) {
      if (x < left - 2 || x > right + 2 || top > y || bottom <= end) continue
      context.lineTo(x, Math.min(bottom, y))
      context.moveTo(x, Math.max(top, end))
    }
    context.lineTo(x, end)
  }
  context.stroke()
}

/** The mark, the name and the rest. */
export function drawCaption(
  context: CanvasRenderingContext2D,
  { caption, box }: Written,
  palette: Palette,
): void {
  const { actor, font, text, time } = caption
  const { fill, text: colour } = colours(caption, palette)
  const baseline = box.bottom - 5
  const { name: left, flag } = partsOf(caption, box)
  if (actor.runner) {
    const path = markOf(actor.runner.paletteIndex, 4.6)
    context.save()
    context.translate(left + 5, baseline - 4.5)
    context.strokeStyle = palette.sheet
    context.lineWidth = 3
    context.stroke(path)
    context.fillStyle = fill
    context.fill(path)
    context.restore()
  }
  context.fillStyle = colour
  const mark = actor.runner ? MARK : 0
  write(context, text, left + mark, baseline, { halo: palette.sheet, font })
  if (actor.end?.kind !== 'at-rest') return
  drawFlag(context, flag, baseline, colour)
  if (time) write(context, time, flag + 10, baseline, { halo: palette.sheet, font })
}

function drawFlag(
  context: CanvasRenderingContext2D,
  x: number,
  baseline: number,
  colour: string,
): void {
  context.strokeStyle = context.fillStyle = colour
  context.lineWidth = 1.2
  context.beginPath()
  context.moveTo(x, baseline + 1)
  context.lineTo(x, baseline - 10)
  context.stroke()
  context.beginPath()
  context.moveTo(x, baseline - 10)
  context.lineTo(x + 7, baseline - 7)
  context.lineTo(x, baseline - 4)
  context.fill()
}
