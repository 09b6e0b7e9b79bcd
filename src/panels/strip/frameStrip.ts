import { html, LitElement, noChange, nothing } from 'lit'
import { fixed } from '../../chart/numbers.ts'
import { frameRate } from '../../view/timeline.ts'
import { onThemeChange } from '../../ui/theme.ts'
import { atNow } from '../../lab/playback/atNow.ts'
import type { Playback } from '../../lab/playback/playback.ts'
import { MOST_RUNNERS } from '../../lab/state/check.ts'
import { hasOwnSteps } from '../../lab/state/clockwork.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'
import { drawPlayhead, drawLane } from './stripDrawing.ts'
import { StripTiles } from './stripTiles.ts'
import type { TimeSpan } from './stripTiles.ts'
import { noteOf, stripText } from './stripWords.ts'

/** With fewer pixels than this to a frame, the time around the cursor is shown enlarged [px]. */
const DENSE = 3
/** So wide are frames there [px]. */
const ENLARGED = 12

/**
 * A lane for each runner on the time axis of the slider above it: a tick at every frame, under `fixed` the physics steps
 * and what the accumulator holds, under `tolerance` the steps and fainter those that were taken back, time that was lost
 * hatched. Where frames are too dense to be seen, the time around the cursor follows enlarged.
 *
 * - `runners`: those that are visible
 * - `duration`: the length of the axis [s]
 * - `playback`: the cursor
 */
class FrameStrip extends LitElement {
  static override properties = {
    runners: { attribute: false },
    duration: { attribute: false },
  }

  declare runners: readonly SimulatedRunner[]
  declare duration: number
  /** Not reactive: it is the same for good, and there when what it was set on becomes this element. */
  declare playback: Playback
  /** Read once a theme: asking for styles between changes of the page is slow. */
  private kept: Colours | undefined
  private width = 0
  /** The whole run, kept: only what is behind it moves. */
  private readonly ticks = document.createElement('canvas')
  private readonly tiles = new StripTiles((tile, stretch) => this.drawLanes(tile, false, stretch))
  private readonly playhead = document.createElement('canvas')
  private playheadSize = { width: 0, height: 0 }
  private stopWatching = () => {}

  override createRenderRoot(): this {
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    this.width = this.clientWidth
    this.playhead.className = 'playhead'
    this.playhead.ariaHidden = 'true'
    const sizes = new ResizeObserver(() => {
      this.width = this.clientWidth
      const { clientWidth: width, clientHeight: height } = this.playhead
      this.playheadSize = { width, height }
      this.requestUpdate()
    })
    for (const each of [this, this.playhead]) sizes.observe(each)
    const stopThemes = onThemeChange(() => {
      this.kept = undefined
      this.requestUpdate()
    })
    const stopTime = this.playback.subscribe(this, 'draw', () => this.follow())
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
    const lanes = layOutLanes(runners, true)
    const window = this.window()
    const at = (of: (time: number) => unknown) => atNow(playback, of)
    const bound = (end: 'from' | 'to') => at(() => fixed(this.window()?.[end] ?? 0, 2))
    const words = (time: number) => runners.map((runner) => stripText(runner, time)).join(' ')
    return html`<div class="overview" .style="height: ${lanes.height}px">
        <canvas aria-hidden="true"></canvas>
        ${runners.map((runner, i) =>
          hasNote(runner)
            ? html`<p class="note" aria-hidden="true" .style="top: ${lanes.boxes[i]!.note}px">
                ${at((time) => noteOf(runner, time))}
              </p>`
            : nothing,
        )}
      </div>
      ${
        window
          ? html`<div class="enlarged" aria-hidden="true">
              <p><span>${bound('from')}</span><span class="to">${bound('to')}&#x202f;s</span></p>
              <canvas .style="height: ${layOutLanes(runners, false).height}px"></canvas>
            </div>`
          : nothing
      }
      ${this.playhead}
      <p class="visually-hidden">${at((time) => (playback.playing ? noChange : words(time)))}</p>`
  }

  override updated(): void {
    this.playhead.style.height = `calc(var(--slider) + ${layOutLanes(this.runners, true).height}px)`
    this.drawLanes(this.ticks, true, { from: 0, to: this.duration })
    this.tiles.forget()
    this.drawOverview(this.window())
    this.follow()
  }

  /** Draws what moves with the cursor, and changes nothing else of the page. */
  private follow(): void {
    const { playback, playheadSize, width } = this
    const window = this.window()
    const enlarged = this.querySelector<HTMLCanvasElement>('.enlarged canvas')
    if (enlarged && window) {
      this.drawOverview(window)
      // Put together from tiles, a tick may be a pixel away from its place.
      if (playback.playing) this.tiles.draw(emptied(enlarged, enlarged), window, devicePixelRatio)
      else this.drawLanes(enlarged, false, window)
    }
    if (playheadSize.width === 0) return
    const depth = layOutLanes(this.runners, true).height
    const at = this.pixels(playback.time)
    const place = { ...playheadSize, length: width, depth, at, moves: playback.playing }
    drawPlayhead(this.playhead, place, this.colours)
  }

  /** The whole run, and behind it the stretch that is enlarged. */
  private drawOverview(window: TimeSpan | undefined): void {
    const pen = emptied(this.querySelector('canvas')!, this.ticks)
    if (window) {
      const ratio = devicePixelRatio
      const left = Math.round(this.pixels(window.from) * ratio)
      const right = Math.round(this.pixels(window.to) * ratio)
      pen.beginPath()
      pen.roundRect(left, 0, right - left, this.ticks.height, 2 * ratio)
      pen.fillStyle = this.colours.ground
      pen.fill()
    }
    pen.drawImage(this.ticks, 0, 0)
  }

  /** The stretch of time around the cursor that is enlarged: undefined where all frames can be seen anyway [s]. */
  private window(): TimeSpan | undefined {
    const { runners, duration, playback, width } = this
    const densest = Math.max(0, ...runners.map(({ trajectory }) => frameRate(trajectory)))
    if (width === 0 || densest * duration <= width / DENSE) return undefined
    const length = width / ENLARGED / densest
    const from = Math.min(Math.max(0, playback.time - length / 2), duration - length)
    return { from, to: from + length }
  }

  private get colours(): Colours {
    return (this.kept ??= coloursOf(this))
  }

  /** A length of time on the axis [px]. */
  private pixels(time: number): number {
    return this.duration > 0 ? (this.width * time) / this.duration : 0
  }

  private drawLanes(canvas: HTMLCanvasElement, noted: boolean, { from, to }: TimeSpan): void {
    if (this.width === 0 || !(to > from)) return
    const ratio = devicePixelRatio
    const { boxes, height } = layOutLanes(this.runners, noted)
    const width = Math.round(this.width * ratio)
    const pen = emptied(canvas, { width, height: Math.round(height * ratio) })
    const { runnerColours, line, wrong } = this.colours
    this.runners.forEach(({ state, trajectory }, i) => {
      const { top, frames, steps } = boxes[i]!
      const tick = Math.min(frames * ratio - ratio, 7 * ratio)
      const lane = {
        top: Math.round(top * ratio + (frames * ratio - tick) / 2),
        tick,
        steps: Math.max(0, steps - 2) * ratio,
      }
      const runner = runnerColours[state.paletteIndex]!
      drawLane(pen, trajectory, { from, to, width, ratio }, lane, { runner, line, wrong })
    })
  }
}

/** A canvas's pen, in its own pixels, on an empty canvas of that size. */
function emptied(
  canvas: HTMLCanvasElement,
  { width, height }: { readonly width: number; readonly height: number },
): CanvasRenderingContext2D {
  // Setting a size is slow, even where it changes nothing.
  if (canvas.width !== width) canvas.width = width
  if (canvas.height !== height) canvas.height = height
  const pen = canvas.getContext('2d')!
  pen.clearRect(0, 0, width, height)
  return pen
}

interface Colours {
  readonly runnerColours: readonly string[]
  readonly line: string
  readonly wrong: string
  readonly ground: string
  readonly accent: string
  readonly sheet: string
}

function coloursOf(element: Element): Colours {
  const style = getComputedStyle(element)
  const colour = (name: string) => style.getPropertyValue(name)
  return {
    runnerColours: Array.from({ length: MOST_RUNNERS }, (_, i) => colour(`--runner-${i}`)),
    line: colour('--line'),
    wrong: colour('--wrong'),
    ground: colour('--ground'),
    accent: colour('--accent'),
    sheet: colour('--sheet'),
  }
}

/** The height of the line under a lane for notes about lost or delayed time [px]. */
const NOTE = 17

/** How high a lane is, and where its note stands [px]. */
interface LaneLayout {
  readonly top: number
  readonly frames: number
  readonly steps: number
  readonly note: number
}

/** Where each runner's lane stands, with or without room for notes. */
function layOutLanes(runners: readonly SimulatedRunner[], noted: boolean) {
  const plain = Math.max(8, 32 / runners.length)
  let height = 0
  const boxes = runners.map((runner): LaneLayout => {
    const top = height
    const stepping = hasOwnSteps(runner.trajectory)
    const frames = stepping ? 10 : plain
    const steps = stepping ? 13 : 0
    const note = top + frames + steps
    height = note + (noted && hasNote(runner) ? NOTE : 0)
    return { top, frames, steps, note }
  })
  return { boxes, height: Math.max(height, 8) }
}

/** Whether there is something to say of a runner's time, at every instant or at none. */
function hasNote(runner: SimulatedRunner): boolean {
  return noteOf(runner, 0) !== ''
}

customElements.define('slide-frame-strip', FrameStrip)
