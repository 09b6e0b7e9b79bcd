import { existsSync } from 'node:fs'
import { resolve } from 'node:path'
import { inChild } from './child.ts'
import { nanoseconds } from './text/numbers.ts'
import { plainTable } from './text/markdown.ts'
import type { Care } from './timing/rounds.ts'
import type { Compared, Kind } from './against/measure.ts'

const titles: Readonly<Record<Kind, string>> = {
  ramp: 'run.frame, one call a step, alone',
  'half-pipe': 'run.frame, one call a step, alone',
  mixed: 'run.frame, one call a step, in a process that has run everything',
  simulate: 'simulate, ten thousand frames: time of a frame',
}

/**
 * Slices of 20 ms and more, so that the processor clock is not too coarse; more of them where there is only one pair.
 */
const careful: Care = { rounds: 41, atLeast: 20, warming: 200 }
const mixed: Care = { ...careful, rounds: 15, warming: 60 }
const hasty: Care = { rounds: 3, atLeast: 0.5, warming: 5 }

/**
 * Compares the processor time of this checkout's physics module with that of another, interleaved in one process for each
 * kind of work, and returns the tables.
 *
 * @param checkout path of the other
 * @param quick few and short slices: to see that it works
 */
export async function compareCheckouts(
  checkout: string,
  quick: boolean,
  tell: (what: string) => void,
): Promise<string> {
  const files = [await bundleWorks('.', 'ours'), await bundleWorks(checkout, 'other')] as const
  const tables: string[] = []
  for (const [kind, title] of Object.entries(titles) as [Kind, string][]) {
    tell(title)
    const care = quick ? hasty : kind === 'mixed' ? mixed : careful
    tables.push(`${title}\n${table(await inChild('against', { kind, files, care }))}`)
  }
  return tables.join('\n\n')
}

function table(compared: readonly Compared[]): string {
  const rows = compared.map((each) => row(nameOf(each), each))
  if (compared.length > 1) {
    const worst = most(compared, ({ ratio }) => ratio)
    const worstByHand = most(compared, ({ handwrittenRatio }) => handwrittenRatio ?? 0)
    rows.push(row(`worst against other: ${nameOf(worst)}`, worst))
    rows.push(row(`worst against handwritten: ${nameOf(worstByHand)}`, worstByHand))
  }
  return plainTable(['', 'ours', 'other', 'ratio', 'handwritten', 'ratio'], rows)
}

function nameOf({ scene, integrator }: Compared): string {
  return `${scene}, ${integrator}`
}

function row(label: string, { ours, other, ratio, handwritten, handwrittenRatio }: Compared) {
  return [
    label,
    nanoseconds(ours),
    nanoseconds(other),
    ratio.toFixed(3),
    handwritten === null ? '–' : nanoseconds(handwritten),
    handwrittenRatio === null ? '–' : handwrittenRatio.toFixed(2),
  ]
}

function most(rows: readonly Compared[], value: (row: Compared) => number): Compared {
  return rows.reduce((worst, each) => (value(each) > value(worst) ? each : worst))
}

/**
 * Bundles `works.ts` of this checkout with the physics module of any checkout, and returns the path. The bundles share no
 * function and no call site, so V8 compiles each for itself.
 *
 * @throws Error where the checkout has no physics module
 */
async function bundleWorks(checkout: string, name: string): Promise<string> {
  const physics = resolve(checkout, 'src/physics/index.ts')
  if (!existsSync(physics)) throw new Error(`“${checkout}” is no checkout: ${physics} is missing.`)
  // Imported here, so that the processes that measure do not load Vite.
  const { build } = await import('vite')
  const outDir = resolve('node_modules/.cache/against', name)
  await build({
    configFile: false,
    publicDir: false,
    logLevel: 'error',
    resolve: {
      alias: [{ find: /^.*\/physics\/index\.ts$/, replacement: physics }],
    },
    build: {
      ssr: resolve('src/report/timing/works.ts'),
      outDir,
      emptyOutDir: true,
      target: 'node20',
    },
  })
  return resolve(outDir, 'works.js')
}
