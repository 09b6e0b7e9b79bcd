import { expect } from 'vitest'
import { openPage } from './page.ts'

type Figure = HTMLElement & {
  values: Record<string, unknown>
  set: (values: Record<string, unknown>) => void
  playback: { time: number; playing: boolean; play: () => void }
  trajectories: unknown[]
}

/** The page with some figures alone on it, one under the other, each on a screen of its own. */
export async function openFigures(
  names: readonly string[],
  options: Parameters<typeof openPage>[0] = {},
) {
  const { page, problems } = await openPage(options)
  await page.evaluate((names) => {
    const main = document.querySelector('main')!
    main.innerHTML = '<h1>Figures</h1><h2>Of the tutorial</h2>'
    for (const name of names) {
      const figure = document.createElement('figure')
      figure.style.cssText = 'max-width: 47rem; margin: 0 auto 3000px'
      figure.innerHTML = `<slide-figure name="${name}"></slide-figure>`
      main.append(figure)
    }
    const changes: unknown[] = []
    Object.assign(window, { changes })
    main.addEventListener('change', (event) => {
      changes.push((event as CustomEvent).detail)
    })
  }, names)
  const figure = (name: string) => page.locator(`slide-figure[name="${name}"]`)
  return {
    page,
    problems,
    figure,
    /** Scrolls to a figure and waits until it is alive. */
    see: async (name: string) => {
      await figure(name).scrollIntoViewIfNeeded()
      await figure(name).and(page.locator('[live]')).waitFor()
      return figure(name)
    },
    values: (name: string) => figure(name).evaluate((each) => (each as Figure).values),
    set: (name: string, values: Record<string, unknown>) =>
      figure(name).evaluate((each, values) => (each as Figure).set(values), values),
    time: (name: string) => figure(name).evaluate((each) => (each as Figure).playback.time),
    says: (name: string) => figure(name).locator('.says').innerText(),
    /** What the event `change` has brought so far. */
    changes: () =>
      page.evaluate(() => (window as unknown as { changes: Record<string, unknown>[] }).changes),
    /** What is on a figure's canvases. */
    pixels: (name: string) =>
      figure(name).evaluate((each) =>
        [...each.querySelectorAll('canvas')].map((canvas) => canvas.toDataURL()).join(),
      ),
    expectNoProblems: () => expect(problems).toEqual([]),
  }
}
