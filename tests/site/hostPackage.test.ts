import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { builtElements, bundlePackaged, openAt, serve } from './hosts.ts'

/* The packed npm package in a page that Vite bundles, beside the built file: they look alike. */

let modules: Record<'file' | 'package', string>
beforeAll(() => {
  modules = {
    file: builtElements().module,
    package: bundlePackaged("import 'any-frame-rate/elements'\n"),
  }
}, 240_000)

async function open(from: keyof typeof modules) {
  const address = await serve((path) =>
    path === 'page.js'
      ? { body: modules[from], type: 'text/javascript' }
      : {
          body: `<!doctype html><html lang="en"><title>Blog</title><slide-lab></slide-lab>
            <slide-lab compact></slide-lab><slide-figure name="falling-ball"></slide-figure>
            <script type="module" src="page.js"></script></html>`,
        },
  )
  const opened = await openAt(address, [], { height: 3000 })
  const { page } = opened
  await page.locator('slide-lab-plots').waitFor()
  await page.locator('slide-figure').scrollIntoViewIfNeeded()
  await page.locator('slide-figure [live]').waitFor()
  return { ...opened, address }
}

/** The size of everything in the elements. */
function seen(page: Page) {
  return page.evaluate(() => {
    const hosts = [...document.querySelectorAll('slide-lab, slide-figure')]
    return hosts.flatMap((host) =>
      [...host.shadowRoot!.querySelectorAll(':not(option)')].map((each) => {
        const { width, height } = each.getBoundingClientRect()
        return `${each.localName}.${each.classList[0] ?? ''} ${Math.round(width)} ${Math.round(height)}`
      }),
    )
  })
}

test('everything in the package’s elements has the size that it has in the built file’s', async () => {
  const [file, packaged] = [await open('file'), await open('package')]
  const expected = await seen(file.page)
  expect(expected.length).toBeGreaterThan(300)
  await expect.poll(() => seen(packaged.page)).toEqual(expected)
  for (const name of ['slide-frame-strip', 'slide-figure-picture canvas']) {
    const box = (await packaged.page.locator(name).first().boundingBox())!
    expect(Math.min(box.width, box.height), name).toBeGreaterThan(20)
  }
  expect(packaged.problems()).toEqual([])
})

test('a page of the package has no lab beside it: nothing is asked for, and no link leads there', async () => {
  const { page, problems } = await open('package')
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  const line = page.locator('slide-lab [part=link]')
  await line.getByRole('button', { name: 'Share' }).click()
  expect(await line.getByRole('button', { name: 'Copy as JSON' }).isVisible()).toBe(true)
  expect(await page.getByRole('button', { name: /link|embed/ }).count()).toBe(0)
  expect(await page.getByRole('link', { name: 'Open in the lab' }).count()).toBe(0)
  expect(asked).toEqual([])
  expect(problems()).toEqual([])
})
