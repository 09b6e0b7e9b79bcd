import { execFileSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Page } from 'playwright-core'
import { build } from 'vite'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import type { SlideFigureElement, SlideLabElement } from '../../src/elements.ts'
import { apps, rendered, start } from './hostApps.ts'
import { builtElements, labMark, openAt, serve } from './hosts.ts'

/* The elements in pages that React and Vue make: what is set comes down, what happens comes up, and it ends. */

const root = join(import.meta.dirname, '../..')
const cache = join(root, 'node_modules/.cache')
let folder: string

beforeAll(() => {
  mkdirSync(cache, { recursive: true })
  folder = mkdtempSync(join(cache, 'hosts-'))
  writeFileSync(join(folder, 'slide-lab.js'), builtElements().module)
}, 180_000)

afterAll(() => rmSync(folder, { recursive: true, force: true }))

async function bundled(name: keyof typeof apps, code = apps[name]): Promise<string> {
  const input = join(folder, `${name}.js`)
  writeFileSync(input, code)
  const built = await build({
    ...{ root: folder, configFile: false, logLevel: 'silent' },
    // The libraries' development builds, which complain.
    define: {
      'process.env.NODE_ENV': '"development"',
      __VUE_OPTIONS_API__: 'true',
      __VUE_PROD_DEVTOOLS__: 'false',
      __VUE_PROD_HYDRATION_MISMATCH_DETAILS__: 'true',
    },
    build: { write: false, minify: false, rolldownOptions: { input } },
  })
  const { output } = built as { output: { code: string }[] }
  return output[0]!.code
}

type Known = Omit<typeof start, 'experiment'> & {
  experiment: Record<string, unknown> | Record<string, unknown>[] | null
}
type Host = { known: Known; put: (part: object) => void; renders: number }

async function openApp(name: keyof typeof apps) {
  const code = await bundled(name)
  const html = `<!doctype html><html lang="en"><title>${name}</title><div id="app"></div>
    <script>window.start = ${JSON.stringify(start)}</script><script type="module" src="app.js"></script></html>`
  const address = await serve((path) =>
    path === 'lab.js'
      ? labMark
      : path === 'app.js'
        ? { body: code, type: 'text/javascript' }
        : { body: html },
  )
  const opened = await openAt(address)
  const { page } = opened
  await page.locator('slide-figure [live]').waitFor()
  return { ...opened, address, ...reading(page) }
}

function reading(page: Page) {
  return {
    put: (part: object) =>
      page.evaluate((part) => (window as unknown as Host).put(part), part as Record<string, never>),
    known: () => page.evaluate(() => (window as unknown as Host).known),
    renders: () => page.evaluate(() => (window as unknown as Host).renders),
    shown: () =>
      page
        .locator('slide-lab')
        .evaluate(
          (lab) =>
            JSON.parse(JSON.stringify((lab as unknown as SlideLabElement).experiments)) as Shown[],
        ),
    values: () =>
      page
        .locator('slide-figure')
        .evaluate((figure) => (figure as unknown as SlideFigureElement).values),
  }
}

type Shown = { parameters: { angle: number }; stopping: string; frames: { fps: number } }

describe.each(['React', 'Vue'] as const)('%s', (name) => {
  test('what is set comes down, and what the reader does comes up and stays', async () => {
    const host = await openApp(name)
    const { page, put, known, shown, values, renders } = host
    expect(await shown()).toMatchObject([{ parameters: { angle: 20 }, frames: { fps: 60 } }])
    expect(await values()).toMatchObject({ step: 0.5 })
    await put({ experiment: { scene: 'ramp', parameters: { angle: 35 } }, fps: '12 24' })
    await expect.poll(shown).toMatchObject([
      { parameters: { angle: 35 }, frames: { fps: 12 } },
      { parameters: { angle: 35 }, frames: { fps: 24 } },
    ])
    await expect.poll(async () => (await known()).fps).toBe(null)

    await page.getByRole('button', { name: 'Clamped' }).click()
    await expect
      .poll(async () => (await known()).experiment)
      .toMatchObject([{ stopping: 'clamped' }, { stopping: 'clamped' }])
    await page.locator('slide-figure').getByRole('slider').last().press('ArrowRight')
    await expect.poll(async () => (await known()).values).toMatchObject({ step: 0.51 })

    // The page renders itself at every instant, and that takes nothing back.
    await page.locator('slide-lab').getByRole('button', { name: 'To the start' }).click()
    await page.locator('slide-lab').getByRole('button', { name: 'Play' }).click()
    await expect.poll(async () => (await known()).time).toBeGreaterThan(0.1)
    expect(await shown()).toMatchObject([{ stopping: 'clamped' }, { stopping: 'clamped' }])
    expect(await values()).toMatchObject({ step: 0.51 })
    await page
      .locator('slide-lab')
      .evaluate((lab) => (lab as unknown as SlideLabElement).playback.pause())

    // What goes up and comes down again asks for nothing more.
    const settled = await page.evaluate(async () => {
      const frames = async (count: number) => {
        for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame)
      }
      await frames(10)
      const before = (window as unknown as Host).renders
      await frames(10)
      return (window as unknown as Host).renders - before
    })
    expect(settled).toBe(0)
    expect(await renders()).toBeGreaterThan(5)
    expect(host.problems()).toEqual([])
  })

  test('what can’t be run is an event and a message, and goes when it is mended', async () => {
    const { page, put, known, shown, problems } = await openApp(name)
    await put({ experiment: { scene: 'ramp', parameters: { angle: 900 } } })
    const alert = page.locator('slide-lab').getByRole('alert')
    await expect.poll(() => alert.innerText()).toContain('900 is not in')
    await expect.poll(async () => (await known()).error).toContain('experiment.parameters.angle')
    await put({ experiment: { scene: 'ramp', parameters: { angle: 9 } } })
    await expect.poll(shown).toMatchObject([{ parameters: { angle: 9 } }])
    expect(await alert.count()).toBe(0)
    await put({ values: { stepp: 1 } })
    const figure = page.locator('slide-figure')
    await expect.poll(() => figure.getByRole('alert').innerText()).toContain('no control “stepp”')
    await put({ values: { step: 0.3 }, name: 'no-such' })
    await expect.poll(() => figure.getByRole('alert').innerText()).toContain('no figure “no-such”')
    expect((await known()).error).toContain('no-such')
    await put({ values: {}, name: 'mass-cancels' })
    await expect
      .poll(() => figure.getByRole('group').first().getAttribute('aria-label'))
      .toBe('A light block and a heavy one')
    expect(await figure.getByRole('alert').count()).toBe(0)
    expect(problems()).toEqual([])
  })

  test('it comes and goes with the page, which keeps what it has put in it', async () => {
    const { page, put, shown, problems } = await openApp(name)
    for (let i = 0; i < 20; i++) {
      await put({ shown: false })
      await expect.poll(() => page.locator('slide-lab, slide-figure').count()).toBe(0)
      await put({ shown: true, time: i })
      await page.locator('slide-figure [live]').waitFor()
    }
    expect(await page.getByText('Fig. 19.0').isVisible()).toBe(true)
    expect(await page.getByText('A picture').isVisible()).toBe(false)
    expect(await shown()).toMatchObject([{ parameters: { angle: 20 } }])
    expect(problems()).toEqual([])
  })

  test('a page that was written on a server is taken over, by the elements and by the library', async () => {
    const { page: parts, server, client } = rendered[name]
    writeFileSync(join(folder, 'page.js'), parts)
    writeFileSync(join(folder, 'server.mjs'), server)
    const markup = execFileSync(process.execPath, [join(folder, 'server.mjs')], {
      encoding: 'utf8',
    })
    expect(markup).toContain('fps="10 60"')
    const code = await bundled(name, `import './slide-lab.js'\n${client}`)
    const html = `<!doctype html><html lang="en"><title>${name}</title><div id="app">${markup}</div>
      <script type="module" src="app.js"></script></html>`
    const address = await serve((path) =>
      path === 'lab.js'
        ? labMark
        : path === 'app.js'
          ? { body: code, type: 'text/javascript' }
          : { body: html },
    )
    const { page, problems } = await openAt(address)
    const { shown, values } = reading(page)
    // As late as can be: both are alive.
    await page.locator('slide-figure [live]').waitFor()
    await page.locator('slide-lab [part=link]').waitFor()
    await page.evaluate(() => (window as unknown as { takeOver: () => void }).takeOver())
    await page.waitForFunction(() => (window as unknown as { isTaken?: true }).isTaken)
    expect(await shown()).toMatchObject([{ frames: { fps: 10 } }, { frames: { fps: 60 } }])
    expect(await values()).toMatchObject({ step: 0.3 })
    expect(await page.getByText('Fig. 1').isVisible()).toBe(true)
    expect(await page.locator('slide-lab').count()).toBe(1)
    expect(problems()).toEqual([])
  })
})
