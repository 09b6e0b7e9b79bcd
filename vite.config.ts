import { defineConfig } from 'vite'

export default defineConfig({
  // Relative addresses, so that the built page works in any folder of any server.
  base: './',
  // A missing file is a 404, not the front page.
  appType: 'mpa',
  build: {
    target: 'es2022',
    rolldownOptions: {
      input: ['index.html'],
    },
  },
  worker: { format: 'es' },
})
