import { resolve } from 'node:path'
import { defineConfig } from 'vite'
import type { Plugin } from 'vite'
import { head } from './src/tutorial/build/head.ts'
import { tutorial } from './src/tutorial/build/plugin.ts'
import { flatTemplates } from './vite.templates.ts'

/** What scripts load others by. */
const helper = '\0vite/preload-helper.js'

export default defineConfig({
  // Relative addresses, so that the built page works in any folder of any server.
  base: './',
  // A missing file is a 404, not the front page.
  appType: 'mpa',
  plugins: [flatTemplates(), tutorial(), preloaded(), sharingWorker(), head()],
  build: {
    target: 'es2022',
    // What does it for every figure would be longer than the wait for one.
    modulePreload: false,
    rolldownOptions: {
      input: ['index.html', 'embed.html', '404.html'],
      // What their index.ts lists and nothing uses is not loaded with it.
      treeshake: {
        moduleSideEffects: [{ test: /\/src\/(physics|measure|chart|view)\//, sideEffects: false }],
      },
      output: {
        codeSplitting: {
          groups: [
            // The page's script loads the lab by it, and would else load it with the lab.
            { name: 'load', test: (id) => id === helper },
            // What is loaded first: the physics and what the lab measures with it, which the worker has too, and the lab. Only the worker drives runs of its own. Files in src itself are the pages' own.
            {
              name: 'physics',
              tags: ['$initial'],
              test: /\/src\/(physics\/(?!createRun\.)|measure\/(rounding|spread|withParameters)\.)/,
            },
            {
              name: 'lab',
              tags: ['$initial'],
              test: /\/(src\/(?!physics|measure|tutorial|panels\/(share|measures)\/)\w+|node_modules)\/.*\.[jt]s$/,
            },
            // What a figure on somebody's page loads besides: less than a whole lab does.
            { name: 'address', test: /\/src\/lab\/(addressLink|lesson|site|state\/address)\./ },
            { name: 'strip', test: /\/src\/(panels\/strip\/|lab\/glide\.)/ },
            // The worker has it too, and can have nothing that draws.
            { name: 'error', test: /\/src\/measure\/error\./ },
            // What a whole lab has is there before any figure comes alive: they share it from here.
            { name: 'instruments', test: /\/src\/panels\/instruments\./ },
            { name: 'figures', test: /\/src\/figures\/(all|element\/live)\./ },
          ],
        },
      },
    },
  },
  // In a frame that is sandboxed, as the embed code's is, a page has no origin, and what it loads comes from another.
  preview: { headers: { 'Access-Control-Allow-Origin': '*' } },
  worker: { format: 'es' },
})

/**
 * Has what a page's script imports, at once or before all else that it asks for later, asked for together with the script:
 * by the page, and not by a script of Vite's.
 */
function preloaded(): Plugin {
  return {
    name: 'preloaded',
    apply: 'build',
    enforce: 'pre',
    load: (id) => (id === helper ? 'export const __vitePreload = (load) => load()' : null),
    transformIndexHtml: {
      order: 'post',
      handler(_, { chunk, bundle = {} }) {
        const files = new Set([
          ...(chunk?.imports ?? []),
          ...(chunk?.dynamicImports ?? []).slice(0, 1),
        ])
        for (const file of files) {
          const imported = bundle[file]
          if (imported?.type === 'chunk') for (const each of imported.imports) files.add(each)
        }
        return [...files].map((file) => ({
          tag: 'link',
          attrs: { rel: 'modulepreload', crossorigin: true, href: `./${file}` },
          injectTo: 'head',
        }))
      },
    },
  }
}

/** Builds the worker as a part of the page, so that it shares the page's physics: as Vite does it, it has its own. */
function sharingWorker(): Plugin {
  const address = "new URL('./measureWorker.ts', import.meta.url)"
  return {
    name: 'sharing-worker',
    apply: 'build',
    enforce: 'pre',
    transform: {
      filter: { id: /\/measurer\.ts$/ },
      handler(code, id) {
        if (!code.includes(address)) this.error(`measurer.ts does not have ${address}`)
        const worker = this.emitFile({ type: 'chunk', id: resolve(id, '../measureWorker.ts') })
        return {
          code: code.replace(address, `import.meta.ROLLUP_FILE_URL_${worker}`),
          map: null,
        }
      },
    },
  }
}
