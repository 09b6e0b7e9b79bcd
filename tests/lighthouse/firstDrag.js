const TILT = '[data-handle="tilt"]'

/**
 * When the lab first answers, on a processor that is four times slower: the reader pulls the track's end up from the
 * first moment on, again and again, until its angle changes. In milliseconds since the page was asked for. A pull is one
 * short move: one that begins a moment too early is over soon, and adds little to what is measured.
 */
export async function firstDrag(browser, address) {
  const { x, y } = await whereItWillBe(browser, address)
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } })
  const page = await context.newPage()
  const session = await context.newCDPSession(page)
  await session.send('Emulation.setCPUThrottlingRate', { rate: 4 })
  await page.addInitScript(noteFirstAnswer)
  await page.goto(address, { waitUntil: 'commit' })

  const answer = () => page.evaluate(() => window.firstAnswer)
  let answered
  while ((answered = await answer()) === undefined) {
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x, y - 30)
    await page.mouse.up()
  }
  await context.close()
  return Math.round(answered)
}

async function whereItWillBe(browser, address) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } })
  await page.goto(address)
  const box = await page.locator(TILT).boundingBox()
  await page.close()
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 }
}

/** In the page: looks at every picture until it shows another angle than the one it began with. */
function noteFirstAnswer() {
  let first
  const look = () => {
    // Not the spread, which the opening changes too.
    const angle = document.querySelector('slide-lab')?.state?.parameters.angle
    first ??= angle
    if (angle !== first)
      // When the picture with it has been handed over.
      requestAnimationFrame(() => setTimeout(() => (window.firstAnswer = performance.now())))
    else requestAnimationFrame(look)
  }
  requestAnimationFrame(look)
}
