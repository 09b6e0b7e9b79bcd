import { resolve } from 'node:path'
import { build } from 'vite'

/**
 * Bundles `works.ts` of this checkout with the physics module of any checkout, and returns the path. The bundles share no
 * function and no call site, so V8 compiles each for itself.
 */
export async function bundleWorks(checkout: string, name: string): Promise<string> {
  const outDir = resolve('node_modules/.cache/against', name)
  await build({
    configFile: false,
    publicDir: false,
    logLevel: 'error',
    resolve: {
      alias: {
        '../physics/index.ts': resolve(checkout, 'src/physics/index.ts'),
      },
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
