import { beforeAll, expect, test } from 'vitest'
import committed from '../hard/fingerprint.json'
import { fingerprintScript } from '../hard/bundle.ts'
import { openPage } from './page.ts'

let bundle: { script: string; expression: string }

beforeAll(async () => {
  bundle = await fingerprintScript()
})

test('the physics computes the same bits in Chromium, on a page', async () => {
  const { page } = await openPage()
  const printed = await page.evaluate<string>(`${bundle.script}\n${bundle.expression}`)
  expect(JSON.parse(printed)).toEqual(committed)
})

test('the physics computes the same bits in Chromium, in a worker', async () => {
  const { page } = await openPage()
  const printed = await page.evaluate(
    (text) =>
      new Promise<string>((resolve, reject) => {
        const address = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }))
        const worker = new Worker(address)
        worker.onmessage = ({ data }) => resolve(data as string)
        worker.onerror = ({ message }) => reject(new Error(message))
      }),
    `${bundle.script}\npostMessage(${bundle.expression})`,
  )
  expect(JSON.parse(printed)).toEqual(committed)
})
