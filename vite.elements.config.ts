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
  plugins: [flatTemplates(), withoutWorker(), withOwnNames()],
  build: {
    target: 'es2022',
    emptyOutDir: false,
    modulePreload: false,
    rolldownOptions: {
      input: { 'slide-lab': 'src/elements.ts' },
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

/**
 * The elements that a lab is made of are defined for the whole page that it stands in, which may have a `share-menu` of
 * its own: here their names begin with `slide-`.
 */
export function withOwnNames(): Plugin {
  return {
    name: 'with-own-names',
    generateBundle(_, bundle) {
      const chunks = Object.values(bundle).filter((each) => each.type === 'chunk')
      const defined = chunks.flatMap(({ code }) => [
        ...code.matchAll(/customElements\.define\(["'`]([\w-]+)/g),
      ])
      const names = defined.map(([, name]) => name!).filter((name) => !name.startsWith('slide-'))
      const name = new RegExp(`(?<![\\w.#-])(?=(${names.join('|')})(?![\\w-]))`, 'g')
      for (const chunk of chunks) chunk.code = chunk.code.replace(name, 'slide-')
    },
  }
}
