/* The elements in pages that other tools make: a Svelte app, a deck of reveal.js, and a manual of MkDocs and of Sphinx. */
import { execFileSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { extname, join } from 'node:path'
import type { Page } from 'playwright-core'
import { compile } from 'svelte/compiler'
import { build } from 'vite'
import { afterAll, beforeAll, expect, test } from 'vitest'
import type { SlideLabElement } from '../../src/elements.ts'
import { builtElements, labMark, openAt, serve } from './hosts.ts'

const types: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
}
const cache = join(import.meta.dirname, '../../node_modules/.cache')
const { module } = builtElements()
let folder: string

beforeAll(() => {
  mkdirSync(cache, { recursive: true })
  folder = mkdtempSync(join(cache, 'sites-'))
  write('slide-lab.js', module)
})

afterAll(() => rmSync(folder, { recursive: true, force: true }))

function write(path: string, text: string): string {
  const file = join(folder, path)
  mkdirSync(join(file, '..'), { recursive: true })
  writeFileSync(file, text)
  return file
}

/** The page with `html` in its body and a script of that text, bundled by Vite. */
async function openBundled(name: string, script: string, html: string) {
  const input = write(`${name}.js`, script)
  const built = await build({
    ...{ root: folder, configFile: false, logLevel: 'silent' },
    build: { write: false, minify: false, rolldownOptions: { input } },
  })
  const code = (built as { output: { code: string }[] }).output[0]!.code
  return openAt(
    await serve((path) => {
      if (path === 'lab.js') return labMark
      if (path === 'app.js') return { body: code, type: 'text/javascript' }
      const body = `<!doctype html><html lang="en"><title>${name}</title>${html}<script type="module" src="app.js"></script></html>`
      return { body }
    }),
  )
}

/** The site that was written to a folder. */
async function openFolder(out: string) {
  return openAt(
    await serve((path) => {
      if (path.endsWith('/lab.js')) return labMark
      const file = join(out, path === '' ? 'index.html' : decodeURIComponent(path))
      try {
        return { body: readFileSync(file), type: types[extname(file)] ?? 'text/plain' }
      } catch {
        return undefined
      }
    }),
  )
}

const stopping = (page: Page) =>
  page
    .locator('slide-lab')
    .evaluate((lab) => (lab as unknown as SlideLabElement).experiments.map((each) => each.stopping))

/** Whether Python has a module; a test without it is skipped, and says how to bring it. */
function hasPython(name: string): boolean {
  try {
    execFileSync('python3', ['-c', `import ${name}`], { stdio: 'ignore' })
    return true
  } catch {
    console.log(`${name} was not tested: python3 has no module of that name (pip install ${name}).`)
    return false
  }
}

test('Svelte hears `change` as it hears that of its own', async () => {
  const app = `<script>
      import './slide-lab.js'
      let told = $state('nothing')
    </script>
    <slide-lab compact fps="10 60" onchange={({ detail }) => (told = detail.experiments[0].stopping)}></slide-lab>
    <p id="told">{told}</p>`
  write('App.js', compile(app, { name: 'App', generate: 'client' }).js.code)
  const { page, problems } = await openBundled(
    'svelte',
    `import { mount } from 'svelte'
     import App from './App.js'
     mount(App, { target: document.querySelector('#app') })`,
    '<div id="app"></div>',
  )
  await page.getByRole('button', { name: 'Located' }).click()
  await expect.poll(() => page.locator('#told').innerText()).toBe('located')
  expect(await stopping(page)).toEqual(['located', 'located'])
  expect(problems()).toEqual([])
})

test('a deck of reveal.js turns no slide, and goes not black, by what is done in the lab', async () => {
  const { page, problems } = await openBundled(
    'reveal',
    `import Reveal from 'reveal.js'
     import './slide-lab.js'
     window.deck = new Reveal({ embedded: false })
     window.ready = window.deck.initialize()`,
    `<div class="reveal"><div class="slides">
       <section>One</section><section><slide-lab></slide-lab></section><section>Three</section>
     </div></div>`,
  )
  interface Deck {
    slide(index: number): void
    getIndices(): { h: number }
    isPaused(): boolean
  }
  const deck = () =>
    page.evaluate(() => {
      const { deck } = window as unknown as { deck: Deck }
      return { slide: deck.getIndices().h, black: deck.isPaused() }
    })
  await page.evaluate(async () => {
    const { ready, deck } = window as unknown as { ready: Promise<void>; deck: Deck }
    await ready
    deck.slide(1)
  })
  const lab = page.locator('slide-lab')
  await lab.locator('slide-runner-row').first().waitFor()
  await lab.getByRole('slider', { name: 'Angle, slider' }).focus()
  for (const key of ['ArrowRight', 'ArrowLeft', 'End', 'Home']) await page.keyboard.press(key)
  await lab.locator('.parameters input[type=text]').first().fill('')
  await page.keyboard.type('1.5b')
  expect(await deck()).toEqual({ slide: 1, black: false })
  await page.evaluate(() => (document.activeElement as HTMLElement).blur())
  await page.keyboard.press('ArrowRight')
  expect((await deck()).slide).toBe(2)
  expect(problems()).toEqual([])
})

test.skipIf(!hasPython('mkdocs'))('a page of MkDocs has it as its recipe says', async () => {
  write('mk/docs/js/slide-lab.js', module)
  write(
    'mk/docs/index.md',
    '# A ramp\n\n<div><slide-lab compact fps="10 60">Blocks</slide-lab></div>\n',
  )
  const config = write(
    'mk/mkdocs.yml',
    `site_name: Manual
theme: { name: mkdocs, highlightjs: false }
extra_javascript: [{ path: js/slide-lab.js, type: module }]
`,
  )
  const out = join(folder, 'mk/out')
  execFileSync('python3', ['-m', 'mkdocs', 'build', '-q', '-f', config, '-d', out])
  await expectAlive(out)
})

test.skipIf(!hasPython('sphinx'))('a page of Sphinx has it as its recipe says', async () => {
  write('sphinx/_static/slide-lab.js', module)
  write(
    'sphinx/conf.py',
    `project = 'Manual'
html_static_path = ['_static']
html_js_files = [('slide-lab.js', {'type': 'module'})]
`,
  )
  write(
    'sphinx/index.rst',
    `A ramp
======

.. raw:: html

   <slide-lab compact fps="10 60">Blocks</slide-lab>
`,
  )
  const out = join(folder, 'sphinx/out')
  execFileSync('python3', ['-m', 'sphinx', '-q', join(folder, 'sphinx'), out])
  await expectAlive(out)
})

/** The lab in that site works, and the page has nothing to say against it. */
async function expectAlive(out: string): Promise<void> {
  const { page, problems } = await openFolder(out)
  await page.getByRole('button', { name: 'Located' }).click()
  expect(await stopping(page)).toEqual(['located', 'located'])
  expect(problems()).toEqual([])
}
