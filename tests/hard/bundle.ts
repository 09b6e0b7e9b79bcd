import { join } from 'node:path'
import { build } from 'vite'

const root = join(import.meta.dirname, '../..')

/**
 * The fingerprint as a script without imports, and the expression that computes it: `{ experiments, hash }` as JSON; and of
 * every fourth experiment, for an engine that is slow. Built by what builds the page.
 */
export async function fingerprintScript(): Promise<{
  script: string
  expression: string
  quarter: string
}> {
  const built = await build({
    root,
    configFile: false,
    logLevel: 'silent',
    build: {
      write: false,
      minify: false,
      target: 'es2022',
      rolldownOptions: {
        input: join(root, 'src/measure/fingerprint.ts'),
        preserveEntrySignatures: 'strict',
        output: { format: 'iife', name: 'AnyFrameRate' },
      },
    },
  })
  const { output } = (Array.isArray(built) ? built[0]! : built) as { output: { code: string }[] }
  return {
    script: output[0]!.code,
    expression: 'JSON.stringify(AnyFrameRate.fingerprint())',
    quarter: `JSON.stringify(AnyFrameRate.fingerprint(AnyFrameRate.fingerprintExperiments().filter((_, i) => i % 4 === 0)))`,
  }
}
