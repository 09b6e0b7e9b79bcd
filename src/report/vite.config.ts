import { defineConfig } from 'vite'

// Node can't run TypeScript: `npm run bench` and `npm run report` build this program first, and nothing of the page.
export default defineConfig({
  publicDir: false,
  logLevel: 'error',
  build: {
    ssr: 'src/report/main.ts',
    outDir: 'node_modules/.cache/report',
    emptyOutDir: true,
    target: 'node20',
  },
})
