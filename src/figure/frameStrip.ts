import { html, LitElement, noChange, nothing } from 'lit'
import { fixed } from '../view/numbers.ts'
import { frameRate } from '../view/timeline.ts'
import { atNow } from './atNow.ts'
import { MOST_RUNNERS } from './check.ts'
import type { Playback } from './playback.ts'
import { drawLane } from './stripDrawing.ts'
import type { SimulatedRunner } from './simulation.ts'
import { clockworkOf, noteOf, stripText } from './stripLanes.ts'
import { onThemeChange } from './theme.ts'

/** With fewer pixels than this to a frame, the time around the cursor is shown enlarged [px]. */
const DENSE = 3
/** So wide are frames there [px]. */
const ENLARGED = 12
/** The line under a lane that says what is odd about its time [px]. */
const NOTE = 17

/**
 * A lane for each runner on the time axis of the slider above it: a tick at every frame, under `fixed` the physics steps
 * and what the accumulator holds, time that was lost hatched. Where frames are too dense to be seen, the time around
 * the cursor follows enlarged.
 *
 * - `runners`: those that are visible
 * - `duration`: the length of the axis [s]
 * - `playback`: the cursor
 */
export class FrameStrip extends LitElement {
  static override properties = {
    runners: { attribute: false },
    duration: { attribute: false },
    playback: { attribute: false },
  }

  declare runners: readonly SimulatedRunner[]
  declare duration: number
  declare playback: Playback
  /** Read once a theme: asking for styles between changes of the page is slow. */
  private colours: Colours | undefined
  private width = 0
  private stopWatching = () => {}

  override createRenderRoot(): this {
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    this.width = this.clientWidth
    const sizes = new ResizeObserver(() => {
      this.width = this.clientWidth
      this.requestUpdate()
    })
    sizes.observe(this)
    const stopThemes = onThemeChange(() => {
      this.colours = undefined
      this.requestUpdate()
    })
    const stopTime = this.playback.watch(this, 'draw', () => this.drawEnlarged())
    this.stopWatching = () => {
      sizes.disconnect()
      stopThemes()
      stopTime()
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopWatching()
  }

  override render() {
    const { runners, playback } = this
    const lanes = this.lanes(true)
    const window = this.window()
    // Moved, not laid out anew.
    const moved = (t: number) => `transform: translateX(${this.pixels(t)}px)`
    const at = (of: (time: number) => unknown) => atNow(playback, of)
    const bound = (end: 'from' | 'to') => at(() => fixed(this.window()?.[end] ?? 0, 2))
    const words = (time: number) => runners.map((runner) => stripText(runner, time)).join(' ')
    return html`<div class="overview" style="height: ${lanes.height}px">
        ${
          window
            ? html`<div
                class="window"
                style="width: ${this.pixels(window.to - window.from)}px; ${at(() =>
                  moved(this.window()?.from ?? 0),
                )}"
              ></div>`
            : nothing
        }
        <canvas aria-hidden="true"></canvas>
        ${runners.map((runner, i) =>
          hasNote(runner)
            ? html`<p class="note" aria-hidden="true" style="top: ${lanes.boxes[i]!.note}px">
                ${at((time) => noteOf(runner, time))}
              </p>`
            : nothing,
        )}
        <div class="cursor" style=${at(moved)}></div>
      </div>
      ${
        window
          ? html`<div class="enlarged" aria-hidden="true">
              <p><span>${bound('from')}</span><span class="to">${bound('to')}&thinsp;s</span></p>
              <canvas style="height: ${this.lanes(false).height}px"></canvas>
            </div>`
          : nothing
      }
      <p class="visually-hidden">${at((time) => (playback.playing ? noChange : words(time)))}</p>`
  }

  override updated(): void {
    this.draw(this.querySelector('canvas')!, true, { from: 0, to: this.duration })
    this.drawEnlarged()
  }

  private drawEnlarged(): void {
    const canvas = this.querySelector<HTMLCanvasElement>('.enlarged canvas')
    const window = this.window()
    if (canvas && window) this.draw(canvas, false, window)
  }

  /** The stretch of time around the cursor that is enlarged: undefined where all frames can be seen anyway [s]. */
  private window(): Stretch | undefined {
    const { runners, duration, playback, width } = this
    const densest = Math.max(0, ...runners.map(({ trajectory }) => frameRate(trajectory)))
    if (width === 0 || densest * duration <= width / DENSE) return undefined
    const length = width / ENLARGED / densest
    const from = Math.min(Math.max(0, playback.time - length / 2), duration - length)
    return { from, to: from + length }
  }

  /** A length of time on the axis [px]. */
  private pixels(time: number): number {
    return this.duration > 0 ? (this.width * time) / this.duration : 0
  }

  /** Where each lane stands, and its note if there is room for notes [px]. */
  private lanes(noted: boolean) {
    const plain = Math.max(8, 32 / this.runners.length)
    let height = 0
    const boxes = this.runners.map((runner) => {
      const top = height
      const stepping = clockworkOf(runner.trajectory).step !== undefined
      const frames = stepping ? 10 : plain
      const steps = stepping ? 13 : 0
      const note = top + frames + steps
      height = note + (noted && hasNote(runner) ? NOTE : 0)
      return { top, frames, steps, note }
    })
    return { boxes, height: Math.max(height, 8) }
  }

  private draw(canvas: HTMLCanvasElement, noted: boolean, { from, to }: Stretch): void {
    const pen = canvas.getContext('2d')
    if (!pen || this.width === 0 || !(to > from)) return
    const ratio = devicePixelRatio
    const { boxes, height } = this.lanes(noted)
    const width = Math.round(this.width * ratio)
    const rows = Math.round(height * ratio)
    if (canvas.width !== width) canvas.width = width
    if (canvas.height !== rows) canvas.height = rows
    pen.clearRect(0, 0, width, rows)
    const { looks, line, wrong } = (this.colours ??= coloursOf(this))
    this.runners.forEach(({ state, trajectory }, i) => {
      const { top, frames, steps } = boxes[i]!
      const tick = Math.min(frames * ratio - ratio, 7 * ratio)
      const lane = {
        top: Math.round(top * ratio + (frames * ratio - tick) / 2),
        tick,
        steps: Math.max(0, steps - 2) * ratio,
      }
      const runner = looks[state.look]!
      drawLane(pen, trajectory, { from, to, width, ratio }, lane, { runner, line, wrong })
    })
  }
}

/** Of time [s]. */
interface Stretch {
  readonly from: number
  readonly to: number
}

/** Whether there is something to say of a runner's time, at every instant or at none. */
function hasNote(runner: SimulatedRunner): boolean {
  return noteOf(runner, 0) !== ''
}

interface Colours {
  readonly looks: readonly string[]
  readonly line: string
  readonly wrong: string
}

function coloursOf(element: Element): Colours {
  const style = getComputedStyle(element)
  const colour = (name: string) => style.getPropertyValue(name)
  const looks = Array.from({ length: MOST_RUNNERS }, (_, i) => colour(`--runner-${i}`))
  return { looks, line: colour('--line'), wrong: colour('--wrong') }
}
