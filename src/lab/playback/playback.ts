import type { ReactiveController, ReactiveControllerHost } from 'lit'
import type { Trajectory } from '../../physics/index.ts'
import { rowAt } from '../../view/timeline.ts'
import { onVisible } from '../../ui/visibility.ts'
import { Subscribers } from './subscribers.ts'
import type { UpdatePhase } from './subscribers.ts'

/** What playback moves through. */
interface PlaybackHost extends ReactiveControllerHost, HTMLElement {
  readonly duration: number
  /** Of the visible runners. */
  readonly recorded: readonly Trajectory[]
}

/** The longest step of the cursor [s], so that a block does not leap after a hidden tab or a busy browser. */
const LONGEST_FRAME = 0.1

/**
 * The interval between updates of text while playing [ms]: nobody reads numbers that change faster, and
 * laying out and painting text costs more than everything that moves.
 */
const WRITING = 95

/**
 * A cursor on the time of recorded runs. It asks for animation frames only while it plays and can be seen. Its position
 * goes to its subscribers; its host is only updated when playing starts or stops.
 */
export class Playback implements ReactiveController {
  playing = false
  /** Playback speed: recorded seconds per second. */
  speed = 1
  private cursor = Infinity
  private seen = false
  private request = 0
  private before = 0
  private written = 0
  private readonly host: PlaybackHost
  private readonly subscribers = new Subscribers()
  private stopWatching = () => {}

  constructor(host: PlaybackHost) {
    this.host = host
    host.addController(this)
  }

  hostConnected(): void {
    this.stopWatching = onVisible(this.host, (isSeen) => {
      this.seen = isSeen
      this.schedule()
    })
  }

  hostDisconnected(): void {
    this.stopWatching()
    this.seen = false
    this.schedule()
  }

  /** The instant shown [s]. A cursor that was put at the end stays there when the run gets longer. */
  get time(): number {
    return Math.min(this.cursor, this.host.duration)
  }

  get isAtEnd(): boolean {
    return this.time >= this.host.duration
  }

  /**
   * Calls back whenever the cursor has moved; while it plays only if the element can be seen, and to `write` only a few
   * times a second. Returns a function that unsubscribes.
   */
  subscribe(element: Element, phase: UpdatePhase, listener: () => void): () => void {
    return this.subscribers.add(element, phase, listener)
  }

  toggle(): void {
    if (this.playing) this.pause()
    else this.play()
  }

  /** Plays on from here, or from the start if this is the end. */
  play(): void {
    if (this.isAtEnd) this.cursor = 0
    this.playing = true
    this.schedule()
    this.host.requestUpdate()
  }

  pause(): void {
    if (this.playing) this.host.requestUpdate()
    this.playing = false
    this.schedule()
    this.subscribers.notify({ seen: false, eachFrame: false })
  }

  /** Goes to an instant [s] and pauses there. */
  seek(time: number): void {
    this.moveTo(time)
    this.pause()
  }

  /** Shows one instant [s] of many that follow each other. */
  show(time: number): void {
    this.moveTo(time)
    this.subscribers.notify({ seen: true, eachFrame: false })
  }

  private moveTo(time: number): void {
    this.cursor = time >= this.host.duration ? Infinity : Math.max(0, time)
  }

  toStart(): void {
    this.seek(0)
  }

  toEnd(): void {
    this.seek(Infinity)
  }

  /** Goes that many frames on, or back if negative: to where the next of any runner's frames is. */
  stepFrames(count: number): void {
    let { time } = this
    for (let i = 0; i < Math.abs(count); i++) time = this.frameBeside(time, count > 0)
    this.seek(time)
  }

  private frameBeside(time: number, later: boolean): number {
    let nearest = later ? this.host.duration : 0
    for (const trajectory of this.host.recorded) {
      const frames = trajectory.time
      const row = rowAt(trajectory, time)
      if (later) nearest = Math.min(nearest, frames[row + 1] ?? nearest)
      else nearest = Math.max(nearest, frames[frames[row]! < time ? row : row - 1] ?? nearest)
    }
    return nearest
  }

  private schedule(): void {
    const wanted = this.playing && this.seen
    if (wanted && this.request === 0) {
      this.before = NaN
      this.written = -Infinity
      this.request = requestAnimationFrame(this.tick)
    } else if (!wanted && this.request !== 0) {
      cancelAnimationFrame(this.request)
      this.request = 0
    }
  }

  private readonly tick = (now: number): void => {
    const passed = Math.min(LONGEST_FRAME, (now - this.before) / 1000 || 0)
    this.before = now
    this.request = requestAnimationFrame(this.tick)
    this.cursor = this.time + this.speed * passed
    if (this.cursor >= this.host.duration) return this.toEnd()
    const isDue = now - this.written >= WRITING
    if (isDue) this.written = now
    this.subscribers.notify({ seen: true, eachFrame: !isDue })
  }
}
