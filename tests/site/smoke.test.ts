import { expect, test } from 'vitest'
import { openPage } from './page.ts'

test('the page opens without a problem', async () => {
  const { page, problems } = await openPage()
  expect(await page.title()).not.toBe('')
  expect(problems).toEqual([])
})
