import { fork } from 'node:child_process'
import { tasks } from './tasks.ts'
import type { TaskName, Tasks } from './tasks.ts'

/** The heap is cleaned only when asked to, and what a million steps allocate is not cleaned before it is counted. */
const flags = ['--expose-gc', '--min-semi-space-size=64', '--max-semi-space-size=64']

/** No task takes this long [ms]: one that does hangs. */
const PATIENCE = 120_000

type Given<N extends TaskName> = Parameters<Tasks[N]>[0]
type Found<N extends TaskName> = Awaited<ReturnType<Tasks[N]>>

/**
 * Runs a task in a fresh process of this same program.
 *
 * @throws Error if the process fails or hangs
 */
export function inChild<N extends TaskName>(name: N, given: Given<N>): Promise<Found<N>> {
  return new Promise((resolve, reject) => {
    const child = fork(process.argv[1]!, ['task', name, JSON.stringify(given)], {
      execArgv: flags,
      stdio: ['ignore', 'ignore', 'pipe', 'ipc'],
      timeout: PATIENCE,
    })
    let complaint = ''
    let found: { value: Found<N> } | undefined
    child.stderr!.on('data', (data: Buffer) => (complaint += data.toString()))
    child.on('message', (message) => (found = message as { value: Found<N> }))
    child.on('error', reject)
    child.on('close', (code, signal) => {
      if (found) resolve(found.value)
      else reject(new Error(lastError(complaint) ?? `ended with ${code ?? signal} and no result`))
    })
  })
}

/** What the process on the other side does. */
export async function beChild(name: string, given: string): Promise<void> {
  const task = tasks[name as TaskName] as (given: unknown) => unknown
  const value = await task(JSON.parse(given))
  await new Promise((sent) => process.send!({ value }, sent))
  process.disconnect()
}

function lastError(text: string): string | undefined {
  return /^\w*Error: .*$/m.exec(text)?.[0]
}
