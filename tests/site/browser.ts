/** Finds and starts the browser that the site tests drive. */
import { spawnSync } from 'node:child_process'
import { existsSync, mkdirSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { join, resolve } from 'node:path'
import { chromium } from 'playwright-core'
import type { BrowserServer } from 'playwright-core'

/** One way to get a browser, and what to call it when it fails. */
type Candidate = { name: string; launch: (args: readonly string[]) => Promise<BrowserServer> }

/** A browser that started. */
type Started = {
  server: BrowserServer
  /** It is the one that npm brings along, the same for everybody. */
  packaged: boolean
}

// No name resolves: the browser cannot fetch, report or update anything, and neither can the page.
const offline = '--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE localhost, EXCLUDE 127.0.0.1'

const packaged: Candidate = {
  name: 'the Chromium in @sparticuz/chromium (Linux, x64)',
  launch: async (args) => {
    const folder = unpack()
    return chromium.launchServer({
      executablePath: join(folder, 'chromium'),
      // The package's own arguments are for servers without a screen: they change how pages behave.
      args: ['--no-sandbox', '--font-render-hinting=none', offline, ...args],
      env: {
        ...process.env,
        LD_LIBRARY_PATH: join(folder, 'al2023', 'lib'),
        FONTCONFIG_PATH: join(folder, 'fonts'),
      },
    })
  },
}

const installed: Candidate = {
  name: 'an installed Google Chrome',
  launch: (args) => chromium.launchServer({ channel: 'chrome', args: [offline, ...args] }),
}

const candidates = process.platform === 'linux' ? [packaged, installed] : [installed]

/**
 * Starts the first candidate that can, with further arguments of Chromium's; throws an error that says what was tried
 * and what to install.
 */
export async function launchBrowser(
  from: readonly Candidate[] = candidates,
  args: readonly string[] = [],
): Promise<Started> {
  const failures: string[] = []
  for (const candidate of from) {
    const { name, launch } = candidate
    try {
      return { server: await launch(args), packaged: candidate === packaged }
    } catch (error) {
      failures.push(`- ${name}: ${reason(error)}`)
    }
  }
  throw new Error(
    [
      'The site tests need a browser and none started. Tried:',
      ...failures,
      'Install Google Chrome (https://www.google.com/chrome/) and run the tests again.',
      'Without a browser, `npx vitest run --project unit` runs all the other tests.',
    ].join('\n'),
  )
}

/** The first line of a message, and what the browser itself said in the log that Playwright adds. */
function reason(error: unknown): string {
  const [first, ...log] = (error instanceof Error ? error.message : String(error)).split('\n')
  return [first, ...log.filter((line) => line.includes('[err]')).slice(0, 3)].join('\n  ')
}

const unpackHere = `
import chromium from '@sparticuz/chromium'
await chromium.executablePath()
`

/**
 * The folder with the unpacked Chromium. The package unpacks into the system's temporary folder and
 * takes whatever lies there for its own, so each version gets a folder, and a folder gets its name
 * only when it is complete: a run that was killed half-way or runs beside this one does no harm.
 */
function unpack(): string {
  const require = createRequire(import.meta.url)
  const home = resolve(require.resolve('@sparticuz/chromium'), '../../..')
  const { version } = require(join(home, 'package.json')) as { version: string }
  const cache = resolve(import.meta.dirname, '../../node_modules/.cache')
  const folder = join(cache, `chromium-${version}`)
  if (existsSync(folder)) return folder

  const partial = `${folder}.${process.pid}`
  mkdirSync(partial, { recursive: true })
  try {
    // The second variable makes it unpack the libraries that a bare Linux lacks.
    const { status, stderr } = spawnSync(
      process.execPath,
      ['--input-type=module', '--eval', unpackHere],
      {
        cwd: import.meta.dirname,
        env: { ...process.env, TMPDIR: partial, AWS_LAMBDA_JS_RUNTIME: 'nodejs22.x' },
        encoding: 'utf8',
      },
    )
    if (status !== 0) {
      throw new Error(`it did not unpack: ${/\w*Error: .*/.exec(stderr)?.[0] ?? stderr}`)
    }
    // The package's own file looks for fonts in /tmp/fonts. A relative cache would lie wherever the tests are started.
    const fonts = join(folder, 'fonts')
    writeFileSync(
      join(partial, 'fonts', 'fonts.conf'),
      `<fontconfig><dir>${fonts}</dir><cachedir>${join(fonts, 'cache')}</cachedir></fontconfig>`,
    )
    if (!existsSync(folder)) renameSync(partial, folder)
  } finally {
    rmSync(partial, { recursive: true, force: true })
  }
  return folder
}
