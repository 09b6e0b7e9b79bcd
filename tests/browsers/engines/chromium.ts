import { chromium as playwright } from 'playwright-core'
import { inject } from 'vitest'
import type { Engine } from './engine.ts'

/** Chromium by Playwright: the browser that the site tests start. */
export const chromium: Engine = {
  name: 'Chromium',
  install: 'npm ci',
  isInstalled: () => true,
  start: async () => {
    const browser = await playwright.connect(inject('browser'))
    const page = await browser.newPage({ reducedMotion: 'reduce' })
    return {
      open: async (address, size) => {
        // From one place of a page to another, nothing would be loaded.
        await page.goto('about:blank')
        await page.setViewportSize(size)
        await page.goto(address)
      },
      run: (call, ...given) =>
        page.evaluate(`(${call.toString()})(...${JSON.stringify(given)})`) as never,
      drag: async (first, ...others) => {
        await page.mouse.move(first!.x, first!.y)
        await page.mouse.down()
        for (const { x, y } of others) await page.mouse.move(x, y)
        await page.mouse.up()
      },
      press: (key) => page.keyboard.press(key),
      shoot: () => page.screenshot(),
      close: () => browser.close(),
    }
  },
}
