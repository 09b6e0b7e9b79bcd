import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { some } from '../samples.ts'
import { logs } from '../logs/written.ts'
import { violationsOn } from './axe.ts'
import { openLab } from './labPage.ts'

const panel = (page: Page) => page.locator('slide-open-log')
const sample = (page: Page) => page.locator('slide-log-sample')
const press = (page: Page, name: string) => panel(page).getByRole('button', { name }).click()

const choose = (page: Page, name: string, text: string) =>
  panel(page)
    .locator('input[type="file"]')
    .setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })

/** Drops a file on the lab's picture. */
const drop = (page: Page, name: string, text: string) =>
  page.evaluate(
    ([name, text]) => {
      const dataTransfer = new DataTransfer()
      dataTransfer.items.add(new File([text!], name!))
      const stage = document.querySelector('slide-stage')!
      for (const type of ['dragover', 'drop'])
        stage.dispatchEvent(
          new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true, composed: true }),
        )
    },
    [name, text],
  )

const summary =
  '30 frames in 0.5 s, median 16.7 ms, longest 50.1 ms, from msBetweenPresents (in ms).'

test('a file that is chosen is summed up, and becomes the clock of a runner that the link brings back', async () => {
  const { page, state, address, problems } = await openLab()
  await choose(page, 'run.csv', logs['PresentMon 1'])
  await expect.poll(() => sample(page).locator('.summary').innerText()).toBe(summary)
  expect(await sample(page).getByRole('img').getAttribute('aria-label')).toContain('30 frames')
  await press(page, 'Use for a new runner')
  await expect
    .poll(() => panel(page).getByRole('status').innerText())
    .toBe('A new runner has the frames of the log.')
  await address(/recorded\(durations:~/)
  const before = await state()
  expect(before.runners).toHaveLength(4)
  await page.reload()
  await expect.poll(state).toEqual(before)
  expect(problems).toEqual([])
})

test('another column and a part of the log can be taken by keyboard alone', async () => {
  const { page } = await openLab()
  await choose(page, 'run.csv', logs['PresentMon 1'])
  const column = sample(page).getByLabel('Column')
  await column.focus()
  await page.keyboard.press('ArrowDown')
  await expect
    .poll(() => sample(page).locator('.summary').innerText())
    .toContain('29 frames in 0.5 s, median 16.7 ms, longest 50.1 ms, from the differences of')
  // Over the unit and the slider.
  for (let i = 0; i < 3; i++) await page.keyboard.press('Tab')
  await page.keyboard.type('0.25')
  await page.keyboard.press('Enter')
  await expect
    .poll(() => sample(page).locator('.summary').innerText())
    .toMatch(/^16 frames in 0\.3 s/)
})

test('a drop and a paste are read alike, and rows that are left out are named', async () => {
  const { page, problems } = await openLab()
  await drop(page, 'broken.csv', 'Application,msBetweenPresents\na.exe,16.6\na.exe,0\nb.exe,NaN\n')
  await expect
    .poll(() => sample(page).locator('.summary').innerText())
    .toBe(
      '1 frame in 16.6 ms, median 16.6 ms, longest 16.6 ms, from msBetweenPresents (in ms); 1 row left out.',
    )
  await sample(page).getByText('1 row left out', { exact: true }).click()
  expect(await sample(page).locator('li').allInnerTexts()).toEqual(['Line 3 is 0'])
  await press(page, 'Close the log')
  expect(await sample(page).count()).toBe(0)
  await press(page, 'Paste a log')
  await page.keyboard.type('16,7\n16,6\n33,3')
  await press(page, 'Read it')
  await expect
    .poll(() => sample(page).locator('.summary').innerText())
    .toContain('3 frames in 66.6 ms')
  await sample(page).getByLabel('Unit').selectOption('s')
  await expect
    .poll(() => sample(page).locator('.summary').innerText())
    .toBe('3 frames in 66.6 s, median 16\u202f700 ms, longest 33\u202f300 ms, from a list in s.')
  await sample(page).getByLabel('Unit').selectOption('ms')
  await press(page, 'Close the log')
  await press(page, 'Paste a log')
  await page.keyboard.type('16,7\n16,6\n33,3')
  await press(page, 'Read it')
  // Its button is gone: the focus goes to what was read, which is read aloud.
  await expect.poll(() => sample(page).count()).toBe(1)
  expect(await page.evaluate(() => document.activeElement!.getAttribute('aria-label'))).toContain(
    'What was pasted: 3 frames in 66.6 ms',
  )
  await press(page, 'Paste a log')
  await page.keyboard.type('no log at all')
  await press(page, 'Read it')
  await expect
    .poll(() => panel(page).getByRole('alert').innerText())
    .toBe('What was pasted: Line 1: this is neither a table nor a list of numbers.')
  expect(problems).toEqual([])
})

test('a log of 300 000 rows is read while the page goes on, and 100 000 of them survive a reload and a way as JSON', async () => {
  const { page, state, problems } = await openLab()
  const [heading, ...rows] = logs['PresentMon 1'].split('\r\n')
  const body = rows.join('\n')
  await page.evaluate(
    ([heading, body]) => {
      const text = [heading, ...Array.from({ length: 10_000 }, () => body)].join('\n')
      const dataTransfer = new DataTransfer()
      dataTransfer.items.add(new File([text], 'long.csv'))
      Object.assign(window, { longest: 0 })
      new PerformanceObserver((list) => {
        for (const { duration } of list.getEntries())
          Object.assign(window, {
            longest: Math.max(duration, (window as unknown as { longest: number }).longest),
          })
      }).observe({ type: 'longtask' })
      const stage = document.querySelector('slide-stage')!
      stage.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }))
    },
    [heading, body],
  )
  await expect
    .poll(() => sample(page).locator('.summary').innerText(), { timeout: 30_000 })
    .toMatch(/^100.000 frames in/)
  const longest = await page.evaluate(() => (window as unknown as { longest: number }).longest)
  console.log(`Longest task while 300 000 rows were read and shown: ${longest} ms.`)
  expect(await panel(page).innerText()).toMatch(/takes 100.000 frames at most/)
  await press(page, 'Use for a new runner')
  await expect.poll(async () => (await state()).runners.length).toBe(4)
  const before = await state()
  await page.waitForTimeout(1000)
  await page.getByRole('button', { name: 'Share' }).click()
  await page.getByRole('button', { name: 'Copy link' }).click()
  expect(await page.locator('slide-share-menu [role="status"]').innerText()).toMatch(
    /^Too many recorded frames for a link: .* Copy it as JSON/,
  )
  await page.reload()
  await expect.poll(async () => (await state()).runners.length, { timeout: 20_000 }).toBe(4)
  expect(await state()).toEqual(before)
  expect(problems).toEqual([])
  const { runners, ...shared } = before
  const json = JSON.stringify(
    runners.map(({ frames, timestep, integrator, stopping }) => {
      return { ...shared, frames, timestep, integrator, stopping }
    }),
  )
  const other = await openLab()
  await drop(other.page, 'lab.json', json)
  await expect.poll(async () => (await other.state()).runners.length, { timeout: 20_000 }).toBe(4)
  expect((await other.state()).runners[3]!.frames).toEqual(runners[3]!.frames)
})

test.each(
  some(
    [
      ['light', 1440],
      ['dark', 768],
      ['light', 390],
      ['dark', 320],
    ] as const,
    ...[0, 3],
  ),
)(
  'axe finds nothing in the %s theme, and nothing sticks out at %d px',
  async (colorScheme, width) => {
    const { page, problems } = await openLab('', { colorScheme, width })
    const rows = ['a.exe,16.7,16.6', 'a.exe,33.3,16.6', 'a.exe,0,16.6', 'b.exe,16.7,9']
    await press(page, 'Paste a log')
    await choose(
      page,
      'a-rather-long-name-of-a-log-of-some-game-2026.csv',
      ['Application,msBetweenPresents,MsBetweenDisplayChange', ...rows].join('\n'),
    )
    await expect.poll(() => sample(page).count()).toBe(1)
    await sample(page).getByText('1 row left out', { exact: true }).click()
    await press(page, 'Paste a log')
    expect(await violationsOn(page, 'slide-open-log')).toEqual([])
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
    expect(problems).toEqual([])
  },
)
