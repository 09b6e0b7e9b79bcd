/** Once for the tests in all engines: the site, the elements' module and the one file, each page with a recorder. */
import { execFileSync } from 'node:child_process'
import { readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import type { TestProject } from 'vitest/node'
import setupSite from '../site/setup.ts'

const root = resolve(import.meta.dirname, '../..')

/** WebDriver does not tell what the console says, so the page does, in all engines alike: `window.problems`. */
const RECORDER = `<script>
window.problems = []
for (const level of ['error', 'warn']) console[level] = (...said) => problems.push(said.join(' '))
addEventListener('error', (event) => problems.push(event.message || 'not loaded: ' + (event.target.src || event.target.href)), true)
addEventListener('unhandledrejection', ({ reason }) => problems.push(String(reason)))
</script>`

export default async function setup(project: TestProject): Promise<() => Promise<void>> {
  let folder = ''
  const noting = {
    provide: ((key: never, value: never) => {
      if (key === 'folder') folder = value
      project.provide(key, value)
    }) as TestProject['provide'],
  } as TestProject
  const teardown = await setupSite(noting)
  for (const config of ['vite.elements.config.ts', 'vite.offline.config.ts']) {
    execFileSync(
      process.execPath,
      [
        join(root, 'node_modules/vite/bin/vite.js'),
        ...['build', '-c', config, '--outDir', folder, '--logLevel', 'warn'],
      ],
      {
        cwd: root,
        env: { ...process.env, NODE_ENV: 'production', VITE_SITE: './' },
        stdio: ['ignore', 'ignore', 'inherit'],
      },
    )
  }
  for (const name of readdirSync(folder)) {
    if (!name.endsWith('.html')) continue
    const page = join(folder, name)
    const html = readFileSync(page, 'utf8')
    writeFileSync(page, html.replace(/<head[^>]*>/, `$&${RECORDER}`))
  }
  writeFileSync(join(folder, 'blank.html'), '<!doctype html><title>Blank</title><body></body>')
  writeFileSync(
    join(folder, 'plain.html'),
    `<!doctype html><html lang="en"><head>${RECORDER}<title>Plain</title><script type="module" src="slide-lab.js"></script></head><body><h1>Plain</h1><slide-lab></slide-lab></body></html>`,
  )
  writeFileSync(
    join(folder, 'sandbox.html'),
    `<!doctype html><html lang="en"><head>${RECORDER}<title>Sandbox</title><script>
addEventListener('message', ({ data }) => { if (data?.type === 'any-frame-rate:height') window.told = data.height })
</script></head><body><iframe sandbox="allow-scripts" src="./embed.html" width="800" height="640"></iframe><script src="embed-resize.js"></script></body></html>`,
  )
  return teardown
}
