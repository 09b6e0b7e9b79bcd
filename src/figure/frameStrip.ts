import { html, LitElement, nothing } from 'lit'
import type { PropertyValues } from 'lit'
import { fixed } from '../view/numbers.ts'
import { frameRate } from '../view/timeline.ts'
import { MOST_RUNNERS } from './check.ts'
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
 * - `time`: the cursor [s]
 */
export class FrameStrip extends LitElement {
  static override properties = {
    runners: { attribute: false },
    duration: { attribute: false },
    time: { attribute: false },
  }

  declare runners: readonly SimulatedRunner[]
  declare duration: number
  declare time: number
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
      this.requestUpdate('runners')
    })
    sizes.observe(this)
    const stopThemes = onThemeChange(() => {
      this.colours = undefined
      this.requestUpdate('runners')
    })
    this.stopWatching = () => {
      sizes.disconnect()
      stopThemes()
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopWatching()
  }

  override render() {
    const { runners, duration, time } = this
    const notes = runners.map((runner) => noteOf(runner, time))
    const lanes = this.lanes(notes)
    const window = this.window()
    const share = (t: number) => within({ from: 0, to: duration }, t)
    return html`<div class="overview" style="height: ${lanes.height}px">
        ${
          window &&
          html`<div
            class="window"
            style="left: ${share(window.from)}; width: ${share(window.to - window.from)}"
          ></div>`
        }
        <canvas aria-hidden="true"></canvas>
        ${notes.map((note, i) =>
          note
            ? html`<p class="note" aria-hidden="true" style="top: ${lanes.boxes[i]!.note}px">
                ${note}
              </p>`
            : nothing,
        )}
        <div class="cursor" style="left: ${share(time)}"></div>
      </div>
      ${
        window &&
        html`<div class="enlarged" aria-hidden="true">
          <p><span>${fixed(window.from, 2)}</span><span>${fixed(window.to, 2)}&thinsp;s</span></p>
          <canvas style="height: ${this.lanes([]).height}px"></canvas>
        </div>`
      }
      <p class="visually-hidden">${runners.map((runner) => stripText(runner, time)).join(' ')}</p>`
  }

  override updated(changes: PropertyValues<this>): void {
    const [overview, enlarged] = this.querySelectorAll('canvas')
    if (changes.has('runners') || changes.has('duration')) {
      const notes = this.runners.map((runner) => noteOf(runner, this.time))
      this.draw(overview!, notes, 0, this.duration)
    }
    const window = this.window()
    if (window) this.draw(enlarged!, [], window.from, window.to)
  }

  /** The stretch of time around the cursor that is enlarged: undefined where all frames can be seen anyway [s]. */
  private window(): { from: number; to: number } | undefined {
    const { runners, duration, time, width } = this
    const densest = Math.max(0, ...runners.map(({ trajectory }) => frameRate(trajectory)))
    if (width === 0 || densest * duration <= width / DENSE) return undefined
    const length = width / ENLARGED / densest
    const from = Math.min(Math.max(0, time - length / 2), duration - length)
    return { from, to: from + length }
  }

  /** Where each lane and its note stand [px]. */
  private lanes(notes: readonly string[]) {
    const plain = Math.max(8, 32 / this.runners.length)
    let height = 0
    const boxes = this.runners.map(({ trajectory }, i) => {
      const top = height
      const stepping = clockworkOf(trajectory).step !== undefined
      const frames = stepping ? 10 : plain
      const steps = stepping ? 13 : 0
      const note = top + frames + steps
      height = note + (notes[i] ? NOTE : 0)
      return { top, frames, steps, note }
    })
    return { boxes, height: Math.max(height, 8) }
  }

  private draw(
    canvas: HTMLCanvasElement,
    notes: readonly string[],
    from: number,
    to: number,
  ): void {
    const pen = canvas.getContext('2d')
    if (!pen || this.width === 0 || !(to > from)) return
    const ratio = devicePixelRatio
    const { boxes, height } = this.lanes(notes)
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

/** How far into a stretch of time an instant is, for a style. */
function within({ from, to }: { from: number; to: number }, time: number): string {
  return `${to > from ? (100 * (time - from)) / (to - from) : 0}%`
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
