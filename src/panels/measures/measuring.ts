import { html, nothing } from 'lit'
import type { LitElement, ReactiveController } from 'lit'
import { onVisible } from '../../ui/visibility.ts'
import { Measurer } from './measurer.ts'
import type { Part, Task } from './task.ts'

/** The wait before a measurement starts, so that none starts during a drag [ms]. */
const PAUSE = 120

/**
 * Measures what an element shows: the newest request, while the element can be seen, and not again once it is done.
 * The element is updated whenever something is heard.
 */
export class Measuring implements ReactiveController {
  /** How much of the request is done, 0 … 1. */
  done = 1
  /** Why it can't be measured, for people. */
  problem = ''
  /** What else went wrong on the way, for people. */
  notice = ''
  /** The reader stopped it. */
  stopped = false
  private readonly measurer = new Measurer((text) => {
    this.notice = text
    this.host.requestUpdate()
  })
  private readonly host: LitElement
  private readonly take: (task: Task, parts: readonly Part[], fresh: boolean) => void
  private task: Task | undefined
  private key = ''
  private timer: ReturnType<typeof setTimeout> | undefined
  private frame: number | undefined
  private isVisible = false
  /** Its button had the focus before the host was updated. */
  private hadFocus = false
  private stopWatching = () => {}

  /** `take` is given what was measured; `fresh` says that it is the first of its task. */
  constructor(
    host: LitElement,
    take: (task: Task, parts: readonly Part[], fresh: boolean) => void,
  ) {
    this.host = host
    this.take = take
    host.addController(this)
  }

  hostConnected(): void {
    this.stopWatching = onVisible(this.host, (isSeen) => {
      this.isVisible = isSeen
      this.look()
    })
    document.addEventListener('visibilitychange', this.look)
  }

  hostUpdate(): void {
    this.hadFocus = this.button?.matches(':focus') ?? false
  }

  /** A button that goes while it has the focus leaves it to the one in its place, or to the words. */
  hostUpdated(): void {
    if (!this.hadFocus || this.button?.matches(':focus')) return
    const words = this.host.querySelector<HTMLElement>('.progress [role="status"]')
    ;(this.button ?? words)?.focus({ preventScroll: true })
  }

  private get button(): HTMLElement | null {
    return this.host.querySelector('.progress button')
  }

  hostDisconnected(): void {
    this.stopWatching()
    document.removeEventListener('visibilitychange', this.look)
    clearTimeout(this.timer)
    this.isVisible = false
    this.measurer.close()
  }

  get busy(): boolean {
    return this.done < 1 && !this.stopped
  }

  /** Sets the task, or none; an equal task changes nothing. */
  want(task: Task | undefined): void {
    const key = task ? JSON.stringify(task) : ''
    if (key === this.key) return
    this.key = key
    this.task = task
    this.stopped = false
    this.problem = ''
    this.done = task ? 0 : 1
    this.measurer.cancel()
    this.later()
  }

  /** Stops until something else is wanted, or the same again. */
  cancel(): void {
    this.stopped = true
    clearTimeout(this.timer)
    this.measurer.cancel()
    this.host.requestUpdate()
  }

  /** After `cancel`, or after it failed. */
  again(): void {
    this.stopped = false
    this.problem = ''
    this.done = 0
    this.host.requestUpdate()
    this.begin()
  }

  /** Measures only while the element is visible. */
  private readonly look = (): void => {
    const seen = this.isVisible && !document.hidden
    if (!seen) this.measurer.cancel()
    else if (!this.measurer.busy) this.later()
  }

  /** Once a frame of the screen, however much is heard: what draws must not hold up what measures. */
  private redraw(): void {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = undefined
      this.host.requestUpdate()
    })
  }

  private later(): void {
    clearTimeout(this.timer)
    this.timer = setTimeout(() => this.begin(), PAUSE)
  }

  private begin(): void {
    const { task } = this
    if (!task || !this.busy || !this.isVisible || document.hidden) return
    let fresh = true
    this.measurer.measure(task, ({ parts, done, problem }) => {
      this.done = done
      this.problem = problem ?? ''
      if (!problem) this.take(task, parts, fresh)
      fresh = false
      this.redraw()
    })
  }
}

/** How far measuring has come, with a button that stops it, or what went wrong. It has its room at all times. */
export function progress(measuring: Measuring) {
  const { busy, done, problem, notice, stopped } = measuring
  return html`<div class="progress">
    ${
      busy
        ? html`<progress max="1" .value=${done} aria-label="Measuring"></progress>
            <button type="button" @click=${() => measuring.cancel()}>Cancel</button>`
        : nothing
    }
    ${
      stopped || problem
        ? html`<button type="button" @click=${() => measuring.again()}>Measure</button>`
        : nothing
    }
    <p role="status" tabindex="-1">
      ${[problem, notice, stopped ? 'Cancelled.' : ''].filter(Boolean).join(' ')}
    </p>
  </div>`
}
