import { existsSync } from 'node:fs'
import { resolve } from 'node:path'

/**
 * Bundles `works.ts` of this checkout with the physics module of any checkout, and returns the path. The bundles share no
 * function and no call site, so V8 compiles each for itself.
 *
 * @throws Error where the checkout has no physics module
 */
export async function bundleWorks(checkout: string, name: string): Promise<string> {
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
      alias: { '../physics/index.ts': physics },
    },
    build: {
      ssr: resolve('src/report/works.ts'),
      outDir,
      emptyOutDir: true,
      target: 'node20',
    },
  })
  return resolve(outDir, 'works.js')
}
