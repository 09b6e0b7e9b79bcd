import { resolve } from 'node:path'
import { build } from 'vite'

/**
 * Bundles the physics module of a checkout into one file and returns its path. Two checkouts that are bundled alike share
 * no function, so V8 compiles each for itself.
 */
export async function bundlePhysics(checkout: string, name: string): Promise<string> {
  const outDir = resolve('node_modules/.cache/against', name)
  await build({
    configFile: false,
    root: checkout,
    publicDir: false,
    logLevel: 'error',
    build: {
      ssr: resolve(checkout, 'src/physics/index.ts'),
      outDir,
      emptyOutDir: true,
      target: 'node20',
    },
  })
  return resolve(outDir, 'index.js')
}
