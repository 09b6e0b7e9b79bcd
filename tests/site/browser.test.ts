import { expect, test } from 'vitest'
import { launchBrowser } from './browser.ts'

test('when no browser starts, the error says what was tried, what happened and what to install', async () => {
  const failing = (name: string, message: string) => ({
    name,
    launch: () => Promise.reject(new Error(message)),
  })
  const attempt = launchBrowser([
    failing('the packaged one', 'wrong architecture'),
    failing('the installed one', 'not found'),
  ])
  await expect(attempt).rejects.toThrow(
    /the packaged one: wrong architecture[^]*the installed one: not found[^]*Install Google Chrome/,
  )
})
