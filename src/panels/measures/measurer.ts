import { Slices } from './slices.ts'
import type { TaskReport } from './slices.ts'
import type { Task } from './task.ts'

/** A worker that is silent this long while it has a task has failed [ms]. A slice takes a thousandth of it. */
const PATIENCE = 8000

/** What is said to the reader when measuring did not go as it should. */
const words = {
  again: 'Measuring had stopped on its own, and was started again.',
  over: 'Measuring stopped on its own a second time. Change something, or ask for it again.',
} as const

/**
 * Measures one task at a time, the newest: in a worker, or where none can be made (from a file, or where a page may
 * have none) in slices of the page's own time. A worker that fails is replaced once for each task.
 */
export class Measurer {
  private worker: Worker | undefined
  /** Instead of a worker. */
  private slices: Slices | undefined
  /** The worker has answered. */
  private ready = false
  private replaced = false
  private id = 0
  private task: Task | undefined
  private listener: (report: TaskReport) => void = () => {}
  private timer: ReturnType<typeof setTimeout> | undefined
  private readonly notice: (text: string) => void

  /** `notice` is called with what the reader should know, and with nothing when that is over. */
  constructor(notice: (text: string) => void) {
    this.notice = notice
  }

  /** Something is being measured. */
  get busy(): boolean {
    return this.task !== undefined
  }

  /** Replaces the current task; its results are dropped. */
  measure(task: Task, listener: (report: TaskReport) => void): void {
    this.replaced = false
    this.notice('')
    this.task = task
    this.listener = listener
    this.begin()
  }

  /** Stops the current task. */
  cancel(): void {
    if (!this.task) return
    this.task = undefined
    this.id++
    clearTimeout(this.timer)
    this.slices?.stop()
    this.worker?.postMessage({ id: this.id })
  }

  /** Stops, and leaves nothing behind. */
  close(): void {
    this.cancel()
    this.drop()
    this.slices?.close()
    this.slices = undefined
  }

  private begin(): void {
    const { task } = this
    const id = ++this.id
    if (!this.slices && !this.worker) this.startWorker()
    if (this.slices) return this.slices.start(task, (report) => this.heard(id, report))
    this.worker?.postMessage({ id, task })
    this.wait()
  }

  private startWorker(): void {
    this.ready = false
    try {
      // In one piece, by which the build knows a worker.
      const worker = new Worker(new URL('./measureWorker.ts', import.meta.url), { type: 'module' })
      worker.onmessage = ({ data }: MessageEvent<{ id: number; report?: TaskReport }>) => {
        if (worker !== this.worker) return
        this.ready = true
        if (data.report) this.heard(data.id, data.report)
        else if (this.task) this.wait()
      }
      worker.onerror = (event) => {
        event.preventDefault()
        if (worker === this.worker) this.lost()
      }
      this.worker = worker
    } catch {
      this.slices = new Slices(() => performance.now())
    }
  }

  private heard(id: number, report: TaskReport): void {
    if (id !== this.id || !this.task) return
    clearTimeout(this.timer)
    if (report.done === 1) this.task = undefined
    else if (this.worker) this.wait()
    this.listener(report)
  }

  private wait(): void {
    clearTimeout(this.timer)
    this.timer = setTimeout(() => this.lost(), PATIENCE)
  }

  /** A worker that never answered is not started again; one that did is replaced. */
  private lost(): void {
    clearTimeout(this.timer)
    this.drop()
    if (!this.ready) this.slices = new Slices(() => performance.now())
    if (!this.task) return
    if (this.ready && this.replaced) {
      this.task = undefined
      this.listener({ parts: [], done: 1, problem: words.over })
      return
    }
    if (this.ready) {
      this.replaced = true
      this.notice(words.again)
    }
    this.begin()
  }

  private drop(): void {
    this.worker?.terminate()
    this.worker = undefined
  }
}
