/** Once for all site tests: a fresh build, served, and a browser to look at it. */
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { preview } from 'vite'
import type { TestProject } from 'vitest/node'
import { launchBrowser } from './browser.ts'

declare module 'vitest' {
  export interface ProvidedContext {
    /** Where the built site is served, with a slash at the end. */
    address: string
    /** The folder that it was built into. */
    folder: string
    /** The folder that the elements' module was built into. */
    elements: string
    /** Where the browser listens for tests. */
    browser: string
    /** It is the one that npm brings along. */
    packaged: boolean
  }
}

const root = resolve(import.meta.dirname, '../..')

export default async function setup(project: TestProject): Promise<() => Promise<void>> {
  // Not dist/, so that tests neither disturb a served build nor see a stale one.
  const [outDir, elements] = ['', 'elements-'].map((name) =>
    mkdtempSync(join(tmpdir(), `any-frame-rate-${name}`)),
  ) as [string, string]
  const undo: (() => unknown)[] = [outDir, elements].map((folder) => () => {
    rmSync(folder, { recursive: true, force: true })
  })
  const teardown = async () => {
    for (const step of undo.reverse()) await step()
  }
  // What a setup that failed leaves open would keep Vitest from ending.
  try {
    const [{ server: browser, packaged }] = await Promise.all([
      launchBrowser(),
      build(outDir),
      build(elements, '-c', 'vite.elements.config.ts'),
    ])
    undo.push(() => browser.close())
    writeFileSync(join(outDir, 'lab.html'), withoutText(join(outDir, 'index.html')))
    const server = await preview({
      root,
      logLevel: 'error',
      build: { outDir },
      // A sandboxed frame asks from no origin.
      preview: { host: '127.0.0.1', port: 0, cors: true },
    })
    undo.push(() => server.close())
    project.provide('address', server.resolvedUrls!.local[0]!)
    project.provide('folder', outDir)
    project.provide('elements', elements)
    project.provide('browser', browser.wsEndpoint())
    project.provide('packaged', packaged)
  } catch (error) {
    await teardown()
    throw error
  }
  return teardown
}

/**
 * The page with its lab and nothing below it, for tests of the lab: it opens in half the time, and a browser that looks for
 * a button by its role does not go through twenty screens of text.
 */
function withoutText(index: string): string {
  const page = readFileSync(index, 'utf8')
  const text = page.slice(page.indexOf('<section class="reading">'), page.indexOf('</main>'))
  return page.replace(text, () => '')
}

/** In a process of its own: Vitest sets NODE_ENV to "test", which would build the development page. */
async function build(outDir: string, ...more: string[]): Promise<void> {
  const vite = join(root, 'node_modules/vite/bin/vite.js')
  const options = ['--outDir', outDir, '--emptyOutDir', '--logLevel', 'warn', ...more]
  const child = spawn(process.execPath, [vite, 'build', ...options], {
    cwd: root,
    env: { ...process.env, NODE_ENV: 'production' },
    stdio: ['ignore', 'ignore', 'inherit'],
  })
  const [code] = (await once(child, 'exit')) as [number | null]
  if (code !== 0) throw new Error(`vite build ${options.join(' ')} failed.`)
}
