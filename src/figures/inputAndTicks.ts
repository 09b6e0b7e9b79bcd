import type { FramesChoice } from '../physics/index.ts'
import { FramesUntil } from '../physics/framesUntil.ts'
import { readPresses } from '../physics/input.ts'
import type { Press } from '../physics/input.ts'
import { wholeSteps } from '../physics/timestepPolicy.ts'
import { dot, line } from '../chart/graph.ts'
import { count, seconds } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import type { DrawingSurface, View } from './shared/figure.ts'

/** What is shown goes round and round [s]. */
const DURATION = 0.5
/** More presses than these can't be told apart. */
const MOST = 8

interface InputValues {
  readonly fps: number
  readonly ticks: number
  readonly clock: 'steady' | 'jitter'
  readonly presses: readonly number[]
}

/** Which ticks hear of a press. */
export const inputAndTicks = figure({
  id: 'input-and-ticks',
  title: 'Presses, frames and ticks',
  pictured:
    'One under the other: when a key went down, the frames, the fixed ticks that they took, the ticks in which the press counts as long as its frame lasts, and the tick that takes it where it is kept.',
  controls: {
    fps: rateControl(50, 15, 144),
    ticks: {
      type: 'number',
      label: 'Ticks',
      unit: '/s',
      from: 20,
      to: 120,
      step: 5,
      initial: 50,
    },
    clock: {
      type: 'choice',
      label: 'Frames',
      options: [
        { id: 'steady', label: 'steady' },
        { id: 'jitter', label: 'jitter' },
      ],
      initial: 'jitter',
    },
    presses: { type: 'frames', label: 'Presses', initial: [0.07, 0.17, 0.3, 0.42], hidden: true },
  },
  experiments: () => [],
  // It does not play, and has a button all the same.
  duration: () => 0,
  action: {
    label: () => 'Press',
    act: (values, now) => ({
      ...values,
      presses: [...values.presses, (now % DURATION) + 1e-6].slice(-MOST),
    }),
  },
  panels: [{ shape: { wide: 0.36, narrow: 0.72 }, draw }],
  says: (values) => {
    const all = pressesOf(values)
    const lost = all.filter(({ counted }) => counted.length === 0).length
    const several = all.filter(({ counted }) => counted.length > 1).length
    const ends = endsOf(values)
    const late = Math.max(...all.map(({ keptIn, time }) => ends[keptIn]! - time))
    const presses = all.length === 1 ? '1 press' : `${all.length} presses`
    return `${presses}. Asked for in each tick, ${lost === 0 ? 'none' : lost} ${lost > 1 ? 'are' : 'is'} lost and ${several === 0 ? 'none counts' : several === 1 ? '1 counts' : `${several} count`} more than once. Kept for a tick, each counts once, ${seconds(late)} after it at the latest.`
  },
  readings: (values) => {
    const all = pressesOf(values)
    const jumps = all.reduce((sum, { counted }) => sum + counted.length, 0)
    return [
      { label: 'Presses', text: count(all.length) },
      { label: 'Jumps, asked in each tick', text: count(jumps), colour: '--runner-1' },
      {
        label: 'Jumps, kept for a tick',
        text: count(all.filter(({ kept }) => kept > 0).length),
        colour: '--runner-0',
      },
    ]
  },
})

/** When frames end [s], until the last press has been taken. */
function endsOf({ fps, ticks, clock }: InputValues): readonly number[] {
  const frames: FramesChoice =
    clock === 'steady' ? { kind: 'steady', fps } : { kind: 'jitter', fps, amount: 0.8, seed: 4 }
  // As many ticks more as presses may have to wait for.
  const each = new FramesUntil({ frames, duration: DURATION + 2 / fps + (MOST + 1) / ticks })
  const ends: number[] = []
  while (each.next()) ends.push(each.time)
  return ends
}

function pressesOf(values: InputValues): readonly Press[] {
  return readPresses(endsOf(values), 1 / values.ticks, values.presses)
}

function draw({ context, width, height, palette }: DrawingSurface, view: View<InputValues>): void {
  const { values } = view
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const [left, right] = [98, width - 16]
  const x = (time: number) => left + ((right - left) * time) / DURATION
  const lane = (part: number) => Math.round(height * part)
  const lanes = {
    ...{ presses: lane(0.09), frames: lane(0.27), ticks: lane(0.45) },
    ...{ asked: lane(0.63), kept: lane(0.79), axis: lane(0.89) },
  }
  const [kept, asked] = [palette.runners[0]!, palette.runners[1]!]
  const name = (text: string, y: number, colour: string) => {
    context.font = `500 12px ${palette.sans}`
    context.fillStyle = colour
    write(context, text, left - 12, y + 4, { align: 'right' })
  }
  const level = (y: number) => {
    context.strokeStyle = palette.edge
    context.lineWidth = 1
    line(context, { x: left, y }, { x: right, y })
  }
  name('presses', lanes.presses, palette.accent)
  name('frames', lanes.frames, palette.ink)
  name('ticks', lanes.ticks, palette.ink)
  name('in each tick', lanes.asked, asked.text)
  name('kept', lanes.kept, kept.text)
  for (const y of [lanes.ticks, lanes.asked, lanes.kept]) level(y)

  context.save()
  context.beginPath()
  context.rect(left - 6, 0, right - left + 12, height)
  context.clip()
  const step = 1 / values.ticks
  const ends = endsOf(values)
  const all = pressesOf(values)
  ends.forEach((end, frame) => {
    const start = ends[frame - 1] ?? 0
    const reads = all.some((press) => press.frame === frame)
    context.fillStyle = reads ? palette.accent : palette.ink
    context.globalAlpha = reads ? 0.35 : frame % 2 ? 0.08 : 0.16
    context.fillRect(x(start), lanes.frames - 9, x(end) - x(start), 18)
    context.globalAlpha = 1
    context.fillStyle = palette.ink
    context.fillRect(x(end) - 1, lanes.frames - 9, 1.5, 18)
    for (let tick = wholeSteps(start, step) + 1; tick <= wholeSteps(end, step); tick++) {
      context.strokeStyle = palette.inkSoft
      context.globalAlpha = 0.6
      line(context, { x: x(tick * step), y: lanes.ticks }, { x: x(end), y: lanes.frames + 9 })
      context.globalAlpha = 1
      dot(context, { x: x(tick * step), y: lanes.ticks }, 3)
    }
  })
  for (const press of all) {
    const at = x(press.time)
    context.strokeStyle = context.fillStyle = palette.accent
    context.lineWidth = 1.5
    line(context, { x: at, y: lanes.presses }, { x: at, y: lanes.frames + 9 })
    context.beginPath()
    context.moveTo(at - 5, lanes.presses - 6)
    context.lineTo(at + 5, lanes.presses - 6)
    context.lineTo(at, lanes.presses + 3)
    context.fill()
    const isRight = press.counted.length === 1
    context.fillStyle = isRight ? asked.fill : palette.wrong
    for (const tick of press.counted) dot(context, { x: x(tick * step), y: lanes.asked }, 5)
    if (press.counted.length === 0) {
      const { x: cx, y: cy } = { x: x(ends[press.frame]!), y: lanes.asked }
      context.strokeStyle = palette.wrong
      context.lineWidth = 2
      line(context, { x: cx - 5, y: cy - 5 }, { x: cx + 5, y: cy + 5 })
      line(context, { x: cx - 5, y: cy + 5 }, { x: cx + 5, y: cy - 5 })
    }
    context.fillStyle = kept.fill
    dot(context, { x: x(press.kept * step), y: lanes.kept }, 5)
  }
  context.restore()

  level(lanes.axis)
  context.font = `11px ${palette.sans}`
  context.fillStyle = palette.inkSoft
  for (let i = 0; i <= 5; i++) {
    const time = (DURATION * i) / 5
    context.fillRect(x(time) - 0.5, lanes.axis, 1, 4)
    const text = i === 5 ? `${time} s` : String(time)
    write(context, text, x(time), lanes.axis + 16, { align: i === 5 ? 'right' : 'center' })
  }
}
