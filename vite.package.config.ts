import { defineConfig } from 'vite'

/** The modules of the npm package: the physics, which needs nothing, and the elements, which need Lit and uPlot. */
export default defineConfig({
  base: './',
  publicDir: false,
  build: {
    target: 'es2022',
    outDir: 'package',
    minify: false,
    modulePreload: false,
    rolldownOptions: {
      input: { physics: 'src/physics/index.ts', elements: 'src/elements.ts' },
      preserveEntrySignatures: 'strict',
      external: /^(lit|uplot)(\/|$)/,
      output: { entryFileNames: '[name].js', chunkFileNames: 'chunks/[name]-[hash].js' },
    },
  },
  worker: { format: 'es' },
})
