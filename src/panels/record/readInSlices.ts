import { readLog } from '../../logs/index.ts'
import type { Candidate } from '../../logs/index.ts'

/** Reads so long without a pause [ms]: a finger on the page waits no longer. */
const SLICE = 8

/**
 * Reads a log while the page goes on.
 *
 * @param progress told now and then how much is read, from 0 to 1; it answers with whether to go on
 * @returns undefined where it was not to go on
 * @throws LogError where no frame time can be read
 */
export async function readInSlices(
  text: string,
  progress: (part: number) => boolean,
): Promise<Candidate[] | undefined> {
  const reading = readLog(text)
  for (;;) {
    const end = performance.now() + SLICE
    let step = reading.next()
    while (!step.done && performance.now() < end) step = reading.next()
    if (step.done) return step.value
    if (!progress(step.value)) return undefined
    await pause()
  }
}

/** Until the page has had its turn. Timers wait for some milliseconds, messages do not. */
function pause(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel()
    port1.onmessage = () => {
      port1.close()
      resolve()
    }
    port2.postMessage(undefined)
  })
}
