import { defineConfig } from 'vite'
import type { Plugin } from 'vite'
import { flatTemplates } from './vite.templates.ts'

/**
 * The elements for other people's pages as one file beside the page, `dist/slide-lab.js`: with all that it needs, and
 * nothing that it would load later.
 */
export default defineConfig({
  base: './',
  publicDir: false,
  plugins: [flatTemplates(), withoutWorker()],
  build: {
    target: 'es2022',
    emptyOutDir: false,
    modulePreload: false,
    rolldownOptions: {
      input: { 'slide-lab': 'src/slideLab.ts' },
      preserveEntrySignatures: 'strict',
      output: { entryFileNames: '[name].js', codeSplitting: false },
    },
  },
})

/** A worker is a file of its own, and other people's pages may not start one: measuring takes the page's own time. */
export function withoutWorker(): Plugin {
  const worker = "new Worker(new URL('./measureWorker.ts', import.meta.url), { type: 'module' })"
  return {
    name: 'without-worker',
    enforce: 'pre',
    transform: {
      filter: { id: /\/measurer\.ts$/ },
      handler(code) {
        if (!code.includes(worker)) throw new Error(`measurer.ts does not have ${worker}`)
        const none = "(() => { throw new Error('There is no worker.') })()"
        return { code: code.replace(worker, `(${none} as Worker)`), map: null }
      },
    },
  }
}
