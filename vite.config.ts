import { defineConfig } from 'vite'
import { tutorial } from './src/tutorial/build/plugin.ts'

export default defineConfig({
  // Relative addresses, so that the built page works in any folder of any server.
  base: './',
  // A missing file is a 404, not the front page.
  appType: 'mpa',
  plugins: [tutorial()],
  build: {
    target: 'es2022',
    rolldownOptions: {
      input: ['index.html', 'embed.html', '404.html'],
    },
  },
  // In a frame that is sandboxed, as the embed code's is, a page has no origin, and what it loads comes from another.
  preview: { headers: { 'Access-Control-Allow-Origin': '*' } },
  worker: { format: 'es' },
})
