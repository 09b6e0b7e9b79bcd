import { execFileSync } from 'node:child_process'
import {
  copyFileSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Page } from 'playwright-core'
import { inject, onTestFinished } from 'vitest'
import { openPage } from './page.ts'

/* Other people's pages: servers of their own, and what they load from the site. */

const root = join(import.meta.dirname, '../..')

/** The module of the elements as it was built for the tests, and the names of all files that this wrote. */
export function builtElements(): { module: string; files: string[] } {
  const folder = inject('elements')
  return {
    module: readFileSync(join(folder, 'slide-lab.js'), 'utf8'),
    files: readdirSync(folder),
  }
}

/**
 * A page's script with the elements from the packed npm package, as Vite bundles it.
 *
 * @param code of the script, which imports `any-frame-rate/elements`
 */
export function bundlePackaged(code: string): string {
  const folder = mkdtempSync(join(tmpdir(), 'any-frame-rate-packed-'))
  const run = (command: string, args: readonly string[], cwd: string) =>
    execFileSync(command, args, {
      cwd,
      env: { ...process.env, NODE_ENV: 'production' },
      stdio: ['ignore', 'ignore', 'inherit'],
    })
  try {
    const vite = join(root, 'node_modules/vite/bin/vite.js')
    const out = join(folder, 'source/package')
    const options = ['-c', 'vite.package.config.ts', '--outDir', out, '--logLevel', 'warn']
    run(process.execPath, [vite, 'build', ...options], root)
    for (const file of ['package.json', 'custom-elements.json'])
      copyFileSync(join(root, file), join(folder, 'source', file))
    run('npm', ['pack', '--ignore-scripts', '--pack-destination', folder], join(folder, 'source'))
    const home = join(folder, 'node_modules/any-frame-rate')
    mkdirSync(home, { recursive: true })
    const tarball = readdirSync(folder).find((name) => name.endsWith('.tgz'))!
    run('tar', ['-xzf', join(folder, tarball), '--strip-components=1', '-C', home], folder)
    for (const name of ['lit', '@lit', 'lit-html', 'lit-element'])
      symlinkSync(join(root, 'node_modules', name), join(folder, 'node_modules', name))
    writeFileSync(join(folder, 'page.js'), code)
    const output = { entryFileNames: '[name].js', codeSplitting: false }
    const config = { base: './', build: { rolldownOptions: { input: 'page.js', output } } }
    writeFileSync(join(folder, 'vite.config.js'), `export default ${JSON.stringify(config)}`)
    run(process.execPath, [vite, 'build', '--logLevel', 'error'], folder)
    return readFileSync(join(folder, 'dist/page.js'), 'utf8')
  } finally {
    rmSync(folder, { recursive: true, force: true })
  }
}

/** By this the elements' file knows that a lab is served beside it. */
export const labMark: Answer = {
  body: readFileSync(join(root, 'public/lab.js')),
  type: 'text/javascript',
}

/** What a server answers: HTML, or with a type and headers of its own. */
type Answer = { body: string | Buffer; type?: string; headers?: Record<string, string> }

/** Serves at an address of its own, which is returned, until the test ends. What is undefined is a 404. */
export async function serve(
  answer: (path: string) => Answer | undefined | Promise<Answer | undefined>,
): Promise<string> {
  const server = createServer((request, response) => {
    void (async () => {
      const found = await answer(request.url!.slice(1).replace(/[?#].*/, ''))
      response.writeHead(found ? 200 : 404, {
        'content-type': found?.type ?? 'text/html; charset=utf-8',
        ...found?.headers,
      })
      response.end(found?.body)
    })()
  })
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done))
  onTestFinished(async () => {
    server.closeAllConnections()
    await new Promise((done) => server.close(done))
  })
  return `http://127.0.0.1:${(server.address() as AddressInfo).port}/`
}

/** Nothing inline, nothing evaluated, nothing from anywhere else. */
const STRICT =
  "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; img-src 'self' data:; worker-src 'self'; connect-src 'self'"

/** The built site at an address of its own, with the elements' module, under a strict Content-Security-Policy. */
export function serveSite(module: string): Promise<string> {
  return serve(async (path) => {
    const headers = { 'Access-Control-Allow-Origin': '*', 'Content-Security-Policy': STRICT }
    if (path === 'slide-lab.js') return { body: module, type: 'text/javascript', headers }
    const response = await fetch(new URL(path, inject('address')))
    const type = response.headers.get('content-type') ?? ''
    return response.ok
      ? { body: Buffer.from(await response.arrayBuffer()), type, headers }
      : undefined
  })
}

/** A page at any address; `problems` are all but that it is not the site's, and requests go to `origins` alone. */
export async function openAt(
  address: string,
  origins: readonly string[] = [],
  options: Parameters<typeof openPage>[0] = {},
): Promise<{ page: Page; problems: () => string[] }> {
  const { page, problems } = await openPage({ ...options, path: '404.html' })
  await page.goto(address)
  const known = [address, ...origins].map((each) => `request leaves the site: ${each}`)
  return {
    page,
    problems: () => problems.filter((each) => !known.some((start) => each.startsWith(start))),
  }
}
