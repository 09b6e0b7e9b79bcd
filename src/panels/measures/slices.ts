import type { Clock } from '../../measure/index.ts'
import { begin } from './task.ts'
import type { Part, TaskWork } from './task.ts'

/** What is told of a task under way. */
export interface TaskReport {
  readonly parts: readonly Part[]
  /** How much of it is done, 0 … 1; at 1 there is no more to come. */
  readonly done: number
  /** Why it could not be done, for people: it is over then. */
  readonly problem?: string
}

/** The length of a slice [ms]: the longest that a new request or the reader's input waits. */
const SLICE = 8

/** Works on one task at a time, in slices, so that another can take its place in between. */
export class Slices {
  private work: TaskWork | undefined
  private yielded = 0
  /** A slice will come. */
  private due = false
  private tell: (report: TaskReport) => void = () => {}
  private readonly clock: Clock
  // Timers wait for some milliseconds, messages do not.
  private readonly pause = new MessageChannel()

  constructor(clock: Clock) {
    this.clock = clock
    this.pause.port1.onmessage = this.slice
  }

  /** Replaces the current task by this one. */
  start(task: unknown, tell: (report: TaskReport) => void): void {
    this.yielded = 0
    this.tell = tell
    try {
      this.work = begin(task, this.clock)
    } catch (error) {
      return this.fail(error)
    }
    this.goOn()
  }

  /** Stops the current task. */
  stop(): void {
    this.work = undefined
  }

  /** Stops, and closes the message channel. */
  close(): void {
    this.stop()
    this.pause.port1.close()
  }

  private readonly slice = (): void => {
    const { work } = this
    this.due = false
    if (!work) return
    const parts: Part[] = []
    const end = this.clock() + SLICE
    try {
      do {
        const { done, value } = work.parts.next()
        if (done) {
          this.stop()
          return this.tell({ parts, done: 1 })
        }
        this.yielded++
        if (value) parts.push(value)
      } while (this.clock() < end)
    } catch (error) {
      return this.fail(error)
    }
    this.tell({ parts, done: Math.min(this.yielded / work.total, 0.999) })
    this.goOn()
  }

  private goOn(): void {
    if (!this.due) this.pause.port2.postMessage(undefined)
    this.due = true
  }

  private fail(error: unknown): void {
    this.stop()
    this.tell({
      parts: [],
      done: 1,
      problem: error instanceof Error ? error.message : String(error),
    })
  }
}
