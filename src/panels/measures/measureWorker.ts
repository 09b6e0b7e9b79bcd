/**
 * Measures in the background. A message `{ id, task }` begins a task in the place of what was under way, `{ id }` alone
 * only stops that. The answers are `{ id, report }`, whose arrays are handed over and not copied; the first of all
 * answers, `{ ready: true }`, says that the worker is there.
 */
import { Slices } from './slices.ts'
import type { TaskReport } from './slices.ts'

const slices = new Slices(() => performance.now())

self.onmessage = ({ data }: MessageEvent<unknown>) => {
  const { id, task } = Object(data) as { id?: unknown; task?: unknown }
  slices.stop()
  if (task !== undefined)
    slices.start(task, (report) => postMessage({ id, report }, { transfer: buffersOf(report) }))
}
postMessage({ ready: true })

function buffersOf({ parts }: TaskReport): Transferable[] {
  return parts
    .flatMap((part) => Object.values(part))
    .filter((value) => ArrayBuffer.isView(value))
    .map(({ buffer }) => buffer as ArrayBuffer)
}
