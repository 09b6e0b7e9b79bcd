/**
 * The same bits on every engine: one hash, committed. `npm test` runs Node, a fourth of it QuickJS, and Chromium in
 * tests/site; `npm run test:engines` every engine that is installed, and says how to get the others.
 */
import { execFileSync } from 'node:child_process'
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import variant from '@jitl/quickjs-wasmfile-release-sync'
import { firefox, webkit } from 'playwright-core'
import { newQuickJSWASMModuleFromVariant } from 'quickjs-emscripten-core'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { fingerprint, fingerprintExperiments } from '../../src/measure/index.ts'
import { isLong } from '../samples.ts'
import { fingerprintScript } from './bundle.ts'
import committed from './fingerprint.json'

// npm tells a script its name.
const runsAll = process.env.npm_lifecycle_event === 'test:engines'

/** Of every fourth combination, since 4 and the number of rules have no divisor in common. */
const experiments = fingerprintExperiments().filter((_, i) => i % 4 === 0)

let bundle: Awaited<ReturnType<typeof fingerprintScript>>

beforeAll(async () => {
  bundle = await fingerprintScript()
})

describe('the same bits in', () => {
  it('QuickJS', async () => {
    const { script, expression, quarter } = bundle
    const quickJS = await newQuickJSWASMModuleFromVariant(variant)
    const of = (asked: string) =>
      JSON.parse(quickJS.evalCode(`${script}\n${asked}`) as string) as unknown
    // An interpreter takes half a minute for all of them.
    if (isLong || runsAll) expect(of(expression)).toEqual(committed)
    else expect(of(quarter)).toEqual(fingerprint(experiments))
  })
})

if (runsAll) describe('every engine that is installed: the same bits in', everyEngine)

function everyEngine(): void {
  const report: string[] = []
  afterAll(() => {
    console.log(report.join('\n'))
  })

  const shells = [
    {
      name: 'SpiderMonkey (gjs)',
      commands: ['gjs'],
      version: '--version',
      install: 'apt-get install gjs',
    },
    {
      name: 'JavaScriptCore (jsc)',
      commands: [
        'jsc',
        '/System/Library/Frameworks/JavaScriptCore.framework/Versions/Current/Helpers/jsc',
      ],
      version: undefined,
      install: 'apt-get install libjavascriptcoregtk-4.0-bin; part of macOS',
    },
  ]

  it.for(shells)('$name', ({ name, commands, version, install }, { skip }) => {
    const command = commands.find(isInstalled)
    if (!command) {
      report.push(`${name}: not installed. ${install}`)
      skip(`not installed: ${install}`)
    }
    const folder = mkdtempSync(join(tmpdir(), 'fingerprint-'))
    const file = join(folder, 'fingerprint.js')
    try {
      writeFileSync(file, `${bundle.script}\nprint(${bundle.expression})\n`)
      const printed = execFileSync(command!, [file], { encoding: 'utf8' })
      expect(JSON.parse(printed)).toEqual(committed)
    } finally {
      rmSync(folder, { recursive: true })
    }
    const which = version ? execFileSync(command!, [version], { encoding: 'utf8' }).trim() : command
    report.push(`${name}: the same bits (${which})`)
  })

  it.for([
    { name: 'Firefox', type: firefox, install: 'npx playwright-core install --with-deps firefox' },
    { name: 'WebKit', type: webkit, install: 'npx playwright-core install --with-deps webkit' },
  ])('$name', async ({ name, type, install }, { skip }) => {
    if (!existsSync(type.executablePath())) {
      report.push(`${name}: not installed. ${install}`)
      skip(`not installed: ${install}`)
    }
    const browser = await type.launch()
    try {
      const page = await browser.newPage()
      const printed = await page.evaluate<string>(`${bundle.script}\n${bundle.expression}`)
      expect(JSON.parse(printed)).toEqual(committed)
      report.push(`${name}: the same bits (${browser.version()})`)
    } finally {
      await browser.close()
    }
  })
}

function isInstalled(command: string): boolean {
  if (command.includes('/')) return existsSync(command)
  const folders = (process.env.PATH ?? '').split(process.platform === 'win32' ? ';' : ':')
  return folders.some((folder) => existsSync(join(folder, command)))
}
