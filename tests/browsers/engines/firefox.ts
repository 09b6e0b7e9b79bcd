import { existsSync } from 'node:fs'
import { launch } from 'puppeteer-core'
import type { KeyInput } from 'puppeteer-core'
import type { Engine } from './engine.ts'

const path = ['/usr/bin/firefox-esr', '/usr/bin/firefox'].find((each) => existsSync(each))

/** Firefox by Puppeteer, over WebDriver BiDi. */
export const firefox: Engine = {
  name: 'Firefox',
  install: 'apt-get install --no-install-recommends firefox-esr',
  isInstalled: () => path !== undefined,
  start: async () => {
    const browser = await launch({
      browser: 'firefox',
      executablePath: path!,
      headless: true,
      extraPrefsFirefox: { 'ui.prefersReducedMotion': 1 },
    })
    const page = await browser.newPage()
    return {
      open: async (address, size) => {
        await page.goto('about:blank')
        await page.setViewport(size)
        await page.goto(address, { waitUntil: 'load' })
      },
      run: (call, ...given) =>
        page.evaluate(`(${call.toString()})(...${JSON.stringify(given)})`) as never,
      drag: async (first, ...others) => {
        await page.mouse.move(first!.x, first!.y)
        await page.mouse.down()
        for (const { x, y } of others) await page.mouse.move(x, y)
        await page.mouse.up()
      },
      press: (key) => page.keyboard.press(key as KeyInput),
      shoot: async () => Buffer.from(await page.screenshot()),
      close: () => browser.close(),
    }
  },
}
