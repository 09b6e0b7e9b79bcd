import { afterAll, beforeAll, describe, expect, inject, test } from 'vitest'
import { chromium } from './engines/chromium.ts'
import type { Tab } from './engines/engine.ts'
import { firefox } from './engines/firefox.ts'
import { webkit } from './engines/webkit.ts'

const engines = [chromium, firefox, webkit]

/** Of the page with the recorder. */
declare global {
  interface Window {
    problems: string[]
  }
}

/** The page at an address of the site, once its lab and its text are there. */
export type OpenPage = (path?: string, width?: number) => Promise<void>

/** The same tests in each engine that is installed; one that is not is skipped under the command that brings it. */
export function inEach(tests: (tab: () => Tab, open: OpenPage, name: string) => void): void {
  for (const engine of engines) {
    if (!engine.isInstalled()) {
      test.skip(`${engine.name} is not installed: ${engine.install}`)
      continue
    }
    describe(engine.name, () => {
      let tab: Tab
      beforeAll(async () => {
        tab = await engine.start()
      })
      afterAll(() => tab.close())
      const open: OpenPage = async (path = '', width = 1280) => {
        await tab.open(new URL(path, inject('address')).href, { width, height: 844 })
        await expect.poll(() => tab.run(isWhole), { timeout: 60_000 }).toBe(true)
      }
      tests(() => tab, open, engine.name)
    })
  }
}

/** What the page loads as soon as its lab is alive is there. */
function isWhole(): boolean {
  return [
    'slide-lab .spread output',
    'slide-lab-measures:defined',
    '.text > section:last-of-type.laid-out',
  ].every((each) => document.querySelector(each) !== null)
}
