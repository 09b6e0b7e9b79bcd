import { chromium } from 'playwright-core'
import type { Page } from 'playwright-core'
import { describe, expect, inject, onTestFinished, test } from 'vitest'
import { launchBrowser } from './browser.ts'
import { openPage } from './page.ts'

/* Readers who need larger letters, or more room between them, in a narrow window: nothing is cut. */

/** What WCAG 1.4.12 lets readers set. */
const spacing = `* {
  line-height: 1.5 !important;
  letter-spacing: 0.12em !important;
  word-spacing: 0.16em !important;
}
p { margin-bottom: 2em !important }`

describe.each([
  ['text of twice the size', 'html { font-size: 200% }'],
  ['WCAG’s text spacing', spacing],
])('with %s at 320 px', (_, content) => {
  test('nothing is cut, and nothing scrolls sideways', async () => {
    const { page } = await openPage({ width: 320, height: 900 })
    await page.addStyleTag({ content })
    await expect.poll(() => cut(page), { timeout: 5000 }).toEqual([])
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320)
  })
})

test.each([320, 1280])('with a smallest letter of 20 px nothing is cut at %d px', async (width) => {
  const { server } = await launchBrowser(undefined, ['--blink-settings=minimumFontSize=20'])
  onTestFinished(() => server.close())
  const browser = await chromium.connect(server.wsEndpoint())
  const page = await browser.newPage({ viewport: { width, height: 900 } })
  await page.goto(inject('address'))
  await page.locator('slide-lab-measures').waitFor()
  const unit = page.locator('.runners .cell-label, .runners .headings').first()
  expect(await unit.evaluate((each) => parseFloat(getComputedStyle(each).fontSize))).toBe(20)
  await expect.poll(() => cut(page), { timeout: 5000 }).toEqual([])
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
})

/** What does not fit: boxes that clip what is in them, menus narrower than their entry, words beyond the window. */
function cut(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const seen = [...document.querySelectorAll<HTMLElement>('body *')].filter((each) => {
      const { width, height } = each.getBoundingClientRect()
      return (
        each.checkVisibility() &&
        !each.closest('svg, math, .contents') &&
        Math.min(width, height) > 2
      )
    })
    return seen.flatMap((each) => {
      const clips = ['hidden', 'clip'].includes(getComputedStyle(each).overflowX)
      const wider = each.scrollWidth - each.clientWidth
      const says = [...each.childNodes].some(
        (node) => node.nodeType === 3 && node.textContent!.trim(),
      )
      const { right, width } = each.getBoundingClientRect()
      const isBeyond = says && right > innerWidth + 1 && !each.closest('pre, [role=region], option')
      const isNarrow = each.matches('select:not(.presets)') && width < naturalWidth(each) - 1
      const name = `${each.localName}.${each.className} ${each.ariaLabel ?? ''} “${each.textContent!.trim().slice(0, 30)}”`
      return [
        (clips || each.matches('input:not([type=range])')) && wider > 1
          ? `cuts ${wider} px: ${name}`
          : '',
        isBeyond ? `ends at ${right}: ${name}` : '',
        isNarrow ? `is ${width} wide, not ${naturalWidth(each)}: ${name}` : '',
      ].filter(Boolean)
    })

    function naturalWidth(menu: HTMLElement): number {
      const { cssText } = menu.style
      menu.style.cssText += '; max-width: none; width: max-content'
      const { width } = menu.getBoundingClientRect()
      menu.style.cssText = cssText
      return width
    }
  })
}
