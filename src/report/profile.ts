import { Session } from 'node:inspector/promises'
import type { Profile } from './schema.ts'
import type { Work } from './timing/rounds.ts'

/** Between two looks at what runs [µs]. */
const INTERVAL = 100
/** [ms] */
const LENGTH = 400
/** So many of them, of those that are more than a half of a hundredth. */
const SHOWN = 6
const LEAST = 0.005

/** Which functions the time of a work goes into, the greatest share first. Inlined functions count for themselves. */
export async function profileOf(what: string, work: Work): Promise<Profile> {
  const session = new Session()
  session.connect()
  await session.post('Profiler.enable')
  await session.post('Profiler.setSamplingInterval', { interval: INTERVAL })
  repeat(work)
  await session.post('Profiler.start')
  repeat(work)
  const { profile } = await session.post('Profiler.stop')
  session.disconnect()
  const hits = new Map<string, number>()
  for (const { callFrame, hitCount } of profile.nodes) {
    const name = callFrame.functionName || 'functions without a name'
    hits.set(name, (hits.get(name) ?? 0) + (hitCount ?? 0))
  }
  const total = [...hits.values()].reduce((sum, count) => sum + count, 0)
  const functions = [...hits]
    .map(([name, count]) => ({ name, share: count / total }))
    .filter(({ share }) => share >= LEAST)
    .sort((a, b) => b.share - a.share)
    .slice(0, SHOWN)
  return { what, functions }
}

function repeat(work: Work): void {
  const end = performance.now() + LENGTH
  while (performance.now() < end) {
    work.prepare?.()
    work.run()
  }
}
