import { describe, expect, test } from 'vitest'
import { openPage } from './page.ts'
import { alive } from './readingPage.ts'

describe('code', () => {
  test('is copied as it stands in its file', async () => {
    const { page } = await openPage()
    await page.evaluate(() => {
      Object.defineProperty(navigator.clipboard, 'writeText', {
        value: (text: string) => Promise.resolve(void (document.title = text)),
      })
    })
    const listing = page.locator('.text > section > .code').first()
    const code = await listing.locator('code').first().textContent()
    await listing.getByRole('button', { name: 'Copy' }).click()
    await listing.getByRole('button', { name: 'Copied' }).waitFor()
    expect((await page.evaluate(() => document.querySelector('title')!.textContent)).trim()).toBe(
      code!.trim(),
    )
  })

  test('is never under its button, and as wide as its lines ask', async () => {
    const narrow = await openPage({ width: 390 })
    const listings = narrow.page.locator('.text .code:visible', { has: narrow.page.locator('pre') })
    await narrow.page.locator('.code .copy').first().waitFor()
    const hidden = await listings.evaluateAll((all) =>
      all.filter((each) => {
        const [button, line] = ['.copy', 'pre .line'].map((at) => each.querySelector(at)!)
        return button!.getBoundingClientRect().bottom > line!.getBoundingClientRect().top
      }),
    )
    expect(hidden).toHaveLength(0)

    const { page } = await openPage({ width: 1440 })
    const short = page.locator('.code', { hasText: 'src/physics/integrators/' })
    const widths = await short.evaluateAll((all) => all.map((each) => each.clientWidth))
    expect(widths).toHaveLength(3)
    expect(new Set(widths).size).toBe(1)
  })

  test('to take home has a tab a language and a choice of dimensions, by mouse and by keyboard', async () => {
    const { page } = await openPage()
    const tabs = page.locator('.take-home').getByRole('tab')
    expect(await tabs.allTextContents()).toEqual([
      ...['TypeScript', 'C++ (Unreal)', 'C# (Unity)', 'GDScript (Godot)'],
    ])
    const shown = page.locator('.take-home [role="tabpanel"]:visible')
    expect(await shown.count()).toBe(1)
    await tabs.nth(1).click()
    expect(await shown.getAttribute('id')).toBe('take-home-cpp')
    await page.keyboard.press('ArrowRight')
    expect(await shown.getAttribute('id')).toBe('take-home-cs')
    expect(await tabs.nth(2).getAttribute('aria-selected')).toBe('true')
    expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('C# (Unity)')
    const three = page.getByRole('group', { name: 'Dimensions' }).getByText('3D')
    await three.click()
    expect(await three.getAttribute('aria-pressed')).toBe('true')
    expect(await shown.getAttribute('id')).toBe('take-home-cs-3d')
    expect(await shown.locator('code').first().textContent()).toContain('Vector3')
    await tabs.nth(0).click()
    expect(await shown.getAttribute('id')).toBe('take-home-ts-3d')
    expect(await tabs.nth(0).getAttribute('aria-controls')).toBe('take-home-ts-3d')
  })
})

test('pointing at a line of code lights the arrow that it computes', async () => {
  const { page, problems } = await openPage({ width: 1280 })
  await alive(page, 'forces-on-slope')
  const figure = page.locator('#figure-forces-on-slope slide-figure')
  const lit = () => figure.evaluate((element) => (element as HTMLElement & { lit?: string }).lit)
  const pictures = new Set<string>()
  const isNew = async () => {
    const picture = await figure
      .locator('canvas')
      .evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL())
    return !pictures.has(picture) && pictures.add(picture).size > 0
  }
  await page.locator('#forces-on-a-slope .code .line:has(.friction)').first().hover()
  expect(await lit()).toBe('friction')
  await expect.poll(isNew).toBe(true)
  await page.locator('#forces-on-a-slope p .gravity').first().hover()
  expect(await lit()).toBe('gravity')
  await expect.poll(isNew).toBe(true)
  await page.locator('.page-foot').hover()
  expect(await lit()).toBe(undefined)
  await expect.poll(isNew).toBe(true)
  expect(problems).toEqual([])
})
