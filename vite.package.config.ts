import { defineConfig } from 'vite'
import { withoutWorker } from './vite.elements.config.ts'

/** The modules of the npm package: the physics and the spread, which need nothing, and the elements, which need Lit. */
export default defineConfig({
  base: './',
  publicDir: false,
  plugins: [withoutWorker()],
  build: {
    target: 'es2022',
    outDir: 'package',
    minify: false,
    lib: {
      entry: {
        physics: 'src/physics/index.ts',
        spread: 'src/measure/gameSpread.ts',
        elements: 'src/elements.ts',
        serverComponent: 'src/serverComponent.ts',
      },
      formats: ['es'],
    },
    rolldownOptions: {
      external: /^lit(\/|$)/,
      output: { chunkFileNames: 'chunks/[name]-[hash].js' },
    },
  },
})
