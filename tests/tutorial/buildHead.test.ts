import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { build } from 'vite'
import { expect, onTestFinished, test, vi } from 'vitest'
import { head } from '../../src/tutorial/build/head.ts'

/* What the page says of itself to search engines and to other sites. */

test.each([
  ['https://example.org/lab/', ['https://example.org/lab/', 'https://example.org/lab/']],
  ['./', []],
])('built for %s, its own address is %j', async (published, expected) => {
  const root = mkdtempSync(join(tmpdir(), 'any-frame-rate-head-'))
  onTestFinished(() => rmSync(root, { recursive: true, force: true }))
  const [start] = readFileSync(join(import.meta.dirname, '../../index.html'), 'utf8').split(
    /<link\s+rel="(?:icon|preload|stylesheet)"/,
  )
  writeFileSync(join(root, 'index.html'), `${start}</head><body></body></html>`)
  vi.stubEnv('VITE_SITE', published)
  onTestFinished(() => void vi.unstubAllEnvs())
  const built = await build({
    ...{ root, configFile: false, logLevel: 'error', plugins: [head()] },
    build: { write: false },
  })
  const { output } = built as { output: { source?: string }[] }
  const html = output.map(({ source }) => source ?? '').join('')
  const own = /<(?:link rel="canonical" href|meta property="og:url" content)="([^"]*)"/g
  expect([...html.matchAll(own)].map(([, address]) => address)).toEqual(expected)
})
