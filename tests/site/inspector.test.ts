import { expect, test } from 'vitest'
import { simulate, traceFrame } from '../../src/physics/index.ts'
import { experimentOf } from '../../src/lab/state/check.ts'
import { numeral } from '../../src/chart/magnitudes.ts'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openLab } from './labPage.ts'

async function openInspector(...options: Parameters<typeof openLab>) {
  const lab = await openLab(...options)
  const inspector = lab.page.locator('slide-step-inspector')
  await inspector.locator('summary').click()
  // What it tells is made once the browser has said that it is open, a moment after the click.
  await inspector.locator('.stepper').first().waitFor()
  const button = (name: string) => inspector.getByRole('button', { name, exact: true })
  return {
    ...lab,
    inspector,
    text: () => inspector.innerText(),
    /** Every number in it as it is, without rounding. */
    numbers: () =>
      inspector
        .locator('.step [title]')
        .evaluateAll((all) => all.map((each) => Number((each as HTMLElement).title))),
    shown: () => inspector.locator('.stepper span').allInnerTexts(),
    frame: (name: string) => button(`${name} frame, inside this step`).click(),
    step: (name: string) => button(`${name} step, inside this step`).click(),
    press: (name: string) => button(name).click(),
  }
}

const LOCATED = 'runners=10;30;120'

test('shows the numbers of the step that ran', async () => {
  const { state, numbers, frame, text, problems, shown } = await openInspector(
    'scene=half-pipe&muKinetic=0.2&muStatic=0.3&runners=10/rk4',
  )
  const lab = await state()
  const experiment = experimentOf(lab, lab.runners[0]!)
  await frame('First')
  for (const row of [1, 2, 3]) {
    expect(await shown()).toEqual([`Frame ${row} of ${simulate(experiment).frames}`])
    const [step] = traceFrame(experiment, row)
    const { evaluations, to } = step!.stretches[0]!.tries[0]!
    const all = await numbers()
    for (const { s, v, drive, press, a } of evaluations)
      expect(all).toEqual(expect.arrayContaining([s, v, drive, press, a]))
    expect(all.slice(-2)).toEqual([to.s, to.v])
    expect(await text()).toContain(
      `It ends at s = ${numeral(to.s)} m with v = ${numeral(to.v)} m/s.`,
    )
    await frame('Next')
  }
  expect(problems).toEqual([])
})

test('explains the stop that was located inside a step', async () => {
  const { press, text, shown, now } = await openInspector(LOCATED)
  expect(await text()).toContain('Nothing to do: at rest since 0.68711 s.')
  await press('Where it stopped')
  expect(await now()).toBeCloseTo(0.7, 12)
  expect(await shown()).toEqual(['Frame 7 of 10'])
  expect(await text()).toContain('One step, as long as the frame: 0.1 s.')
  expect(await text()).toContain(
    'v reached 0 after 0.087108 s of 0.1 s, found in 2 tries; s = −1.7178 m; it stays, because |drive| 2.5390 ≤ μs press 4.7379 m/s².',
  )
  expect(await text()).toContain('It ends at s = −1.7178 m with v = 0 m/s.')
})

test('follows the cursor, the selected runner and every change', async () => {
  const { text, shown, time, runner, page } = await openInspector()
  await time().fill('0.35')
  expect(await shown()).toEqual(['Frame 3 of 10'])
  await runner(1).locator('select').first().focus()
  expect(await shown()).toEqual(['Frame 10 of 30'])
  expect(await text()).toMatch(/30 fps/)
  await time().fill('0')
  expect(await text()).toContain(
    'Nothing has been stepped yet: the first frame ends at 0.033333 s.',
  )
  await time().fill('1')
  await page.getByRole('button', { name: 'The paper' }).click()
  expect(await text()).toContain('v′ = v + a(s, v) Δt')
  await page.getByRole('button', { name: 'Located' }).click()
  await time().fill('0.1')
  expect(await text()).toContain('s′ = s + v Δt + ½ a Δt²')
})

test('goes through the steps of a frame, and begins with the one in which something happened', async () => {
  const { text, shown, step, press } = await openInspector('runners=10/fixed(step:1/60)/clamped')
  expect(await text()).toContain('6 fixed steps of 0.016667 s, 0 s left in the accumulator.')
  expect(await text()).toContain('Nothing to do: at rest since')
  await press('Where it stopped')
  // The clamp ends one step at rest, and the next finds that it stays.
  expect(await shown()).toEqual(['Frame 7 of 10', 'Step 6 of 6'])
  expect(await text()).toMatch(/v would have been [\d.]+ m\/s: set to 0\./)
  const before = await text()
  await step('First')
  expect(await shown()).toEqual(['Frame 7 of 10', 'Step 1 of 6'])
  expect(await text()).not.toBe(before)
  await step('Next')
  expect(await shown()).toEqual(['Frame 7 of 10', 'Step 2 of 6'])
  await press('Where something happened')
  expect(await text()).toBe(before)
})

test('is asked for only while it is open, now and then while it plays, and exactly at the pause', async () => {
  const lab = await openLab('duration=3&runners=60')
  const { page } = lab
  const details = page.locator('details.inspector')
  expect(await details.locator('.step').count()).toBe(0)
  await details.locator('summary').click()
  await page.getByRole('button', { name: 'To the start' }).click()
  await page.evaluate(() => {
    const watched = document.querySelector('slide-step-inspector')!
    // What can't be seen does not follow.
    watched.querySelector('summary')!.scrollIntoView()
    const seen = new Set<string>()
    const observer = new MutationObserver(() =>
      seen.add(watched.querySelector('.stepper span')!.textContent),
    )
    observer.observe(watched, { subtree: true, characterData: true, childList: true })
    document.querySelector<HTMLElement>('.play')!.click()
    setTimeout(() => {
      document.querySelector<HTMLElement>('.play')!.click()
      observer.disconnect()
      Object.assign(window, { changes: seen.size })
    }, 1200)
  })
  // Asked for, not waited for in the page: Chromium now and then drops a promise that a tool waits for.
  const changesNow = () => page.evaluate(() => (window as { changes?: number }).changes ?? 0)
  await expect.poll(changesNow).toBeGreaterThan(0)
  const changes = await changesNow()
  expect(changes).toBeGreaterThan(1)
  expect(changes).toBeLessThan(9)
  const row = Math.floor((await lab.now()) * 60 + 1e-6)
  await expect
    .poll(() => details.locator('.stepper span').first().innerText())
    .toBe(`Frame ${row} of 180`)
  await details.locator('summary').click()
  await expect.poll(() => details.locator('.step').count()).toBe(0)
})

test('works by keyboard alone', async () => {
  const { page, problems } = await openLab(LOCATED)
  await page.locator('.inspector summary').focus()
  await page.keyboard.press('Enter')
  await page.locator('.inspector .stepper').waitFor()
  const press = async (name: string) => {
    for (let i = 0; i < 8; i++) {
      await page.keyboard.press('Tab')
      if (
        (await page.evaluate(
          () => document.activeElement!.textContent.trim() || document.activeElement!.ariaLabel,
        )) === name
      )
        return page.keyboard.press('Enter')
    }
    throw new Error(`Tab does not come to ${name}`)
  }
  await press('Where it stopped')
  await expect
    .poll(() => page.locator('.inspector .stepper span').innerText())
    .toBe('Frame 7 of 10')
  expect(problems).toEqual([])
})

test.each(
  some(
    [
      ['light', 1280],
      ['dark', 320],
    ] as const,
    1,
  ),
)(
  'axe finds nothing in the %s theme, and nothing sticks out at %d px',
  async (colorScheme, width) => {
    for (const address of some(
      [
        LOCATED,
        'scene=half-pipe&muKinetic=0.2&muStatic=0.3&runners=10/rk4/fixed(step:1/60)',
        'runners=10/implicit-midpoint/naive',
        'scene=spring&runners=10/yoshida4',
      ],
      ...[0, 1],
    )) {
      const { inspector, press, page, frame, problems } = await openInspector(address, {
        colorScheme,
        width,
      })
      if (await inspector.getByRole('button', { name: 'Where it stopped' }).count())
        await press('Where it stopped')
      else await frame('First')
      expect(await violationsOn(page, 'slide-step-inspector')).toEqual([])
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
      expect(problems).toEqual([])
    }
  },
)
