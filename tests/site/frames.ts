/** What a page shows from frame to frame: waits that last as long as a busy machine needs. */
import type { Locator, Page } from 'playwright-core'

/** How many animation frames a page asks for in a while: polled, it is 0 once the page has come to rest. */
export function framesAsked(page: Page): Promise<number> {
  return page.evaluate(async () => {
    const { requestAnimationFrame } = window
    let count = 0
    window.requestAnimationFrame = (callback) => (count++, requestAnimationFrame(callback))
    await new Promise((done) => setTimeout(done, 400))
    window.requestAnimationFrame = requestAnimationFrame
    return count
  })
}

/** Waits until whoever watches whether an element is on the screen has been told that it is not. */
export function outOfSight(element: Locator): Promise<void> {
  return element.evaluate(
    (element) =>
      new Promise<void>((done) => {
        const observer = new IntersectionObserver(([entry]) => {
          if (entry!.isIntersecting) return
          observer.disconnect()
          done()
        })
        observer.observe(element)
      }),
  )
}

/** Scrolls through a page, a screen at a time, and lets the browser paint each. */
export async function scrollThrough(page: Page): Promise<void> {
  const { height } = page.viewportSize()!
  const screens = await page.evaluate(
    (height) => Math.ceil(document.documentElement.scrollHeight / height),
    height,
  )
  for (let i = 0; i < screens; i++) {
    await page.evaluate((y) => scrollTo(0, y), i * height)
    await page.evaluate(() => new Promise(requestAnimationFrame))
    // Chromium 143 on two cores: who scrolls on before what is shown is painted may never be given another frame.
    await page.waitForTimeout(60)
  }
}
