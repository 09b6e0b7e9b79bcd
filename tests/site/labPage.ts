import type { Page } from 'playwright-core'
import { expect } from 'vitest'
import type { LabState } from '../../src/lab/state/state.ts'
import { openPage } from './page.ts'
import { Picture } from './picture.ts'

export type Lab = Awaited<ReturnType<typeof openLab>>

/** Opens the lab, with nothing below it, at an address, the part after `#`. */
export function openLab(address = '', options: Parameters<typeof openPage>[0] = {}) {
  return openLabOf('lab.html', address, options)
}

/** Opens the whole page, with its lab at an address. */
export function openLabOverText(address = '', options: Parameters<typeof openPage>[0] = {}) {
  return openLabOf('', address, options)
}

async function openLabOf(file: string, address: string, options: Parameters<typeof openPage>[0]) {
  const { page, problems } = await openPage({
    path: file + (address && `#${address}`),
    ...options,
  })
  const state = () =>
    page.evaluate(
      () => (document.querySelector('slide-lab') as unknown as { state: LabState }).state,
    )
  return {
    page,
    problems,
    state,
    /** The parameter's field. */
    field: (label: string) => page.getByRole('textbox', { name: label, exact: false }).first(),
    slider: (label: string) => page.getByRole('slider', { name: `${label}, slider` }),
    handle: (name: string) => page.getByRole('slider', { name }),
    spread: () => page.locator('.spread output').innerText(),
    runner: (index: number) => page.locator('slide-runner-row').nth(index),
    /** The instant that is shown [s]. The slider rounds it. */
    now: () =>
      page.evaluate(
        () =>
          (document.querySelector('slide-lab') as unknown as { playback: { time: number } })
            .playback.time,
      ),
    /** As if it were typed into the address bar. */
    goTo: (hash: string) => page.evaluate((hash) => void (location.hash = hash), hash),
    time: () => page.getByRole('slider', { name: 'Time', exact: true }),
    /** What is on the canvas, to be compared with what was. */
    pixels: async () => {
      await page.locator('slide-lab:not([gliding])').first().waitFor()
      const png = await page.evaluate(() =>
        document.querySelector<HTMLCanvasElement>('slide-stage canvas')!.toDataURL(),
      )
      return new Picture(png)
    },
    /** Once it is what it should be: it is written a little later than the picture. */
    address: (expected: string | RegExp) =>
      expect.poll(() => page.evaluate(() => decodeURIComponent(location.hash))).toMatch(expected),
  }
}

/** The middle of an element, in the window. */
export async function middle(page: Page, selector: string): Promise<{ x: number; y: number }> {
  const box = (await page.locator(selector).boundingBox())!
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}
