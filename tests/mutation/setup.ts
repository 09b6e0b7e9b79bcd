/**
 * Stryker expects each test file to have a module world to itself. Here all files share one, which spares a second or
 * more a mutant: what one file has left there is cleared before the next is read.
 */
import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import { inject } from 'vitest'
import type { FrameLoop } from '../../src/physics/frameLoop.ts'

interface Shared {
  __stryker__?: {
    activeMutant?: string | undefined
    mutantCoverage?: { static: object; perTest: object }
  }
  endsSet?: boolean
}

// Stryker runs tests in worker threads, which take no --expose-gc.
setFlagsFromString('--expose-gc')
globalThis.gc ??= runInNewContext('gc') as NonNullable<typeof globalThis.gc>

const shared = globalThis as Shared
const stryker = shared.__stryker__

if (stryker?.mutantCoverage) Object.assign(stryker.mutantCoverage, { static: {}, perTest: {} })
// What a file computes while it is read is right, unless the mutant is in code that runs then.
if (stryker && inject('mutantActivation' as never) === 'runtime') stryker.activeMutant = undefined

// More frames than any test here runs.
const MOST_FRAMES = 300_000

// A clock that a mutant has stopped would keep a run going until the time is up, for every such mutant half a minute.
if (!shared.endsSet) {
  shared.endsSet = true
  // Not before the coverage is cleared: what runs while the sources are read counts.
  const { prototype } = (await import('../../src/physics/frameLoop.ts')).FrameLoop
  const next = Object.getOwnPropertyDescriptor(prototype, 'next')!.value as () => boolean
  prototype.next = function (this: FrameLoop): boolean {
    if (this.run.frames > MOST_FRAMES) throw new Error('The run has no end.')
    return next.call(this)
  }
}
