import type { Page } from 'playwright-core'

/** Scrolls to the figure of that name, and waits until it is alive. */
export async function alive(page: Page, name: string): Promise<void> {
  await page.locator(`#figure-${name}`).scrollIntoViewIfNeeded()
  await page.locator(`slide-figure[name="${name}"][live]`).waitFor()
}

/** The values that a figure has. */
export function valuesOf(page: Page, name: string): Promise<Record<string, unknown>> {
  return page
    .locator(`slide-figure[name="${name}"]`)
    .evaluate((figure) => (figure as unknown as { values: Record<string, unknown> }).values)
}
