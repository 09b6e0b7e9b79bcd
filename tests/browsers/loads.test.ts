import { expect, inject, test } from 'vitest'
import { pathToFileURL } from 'node:url'
import { join } from 'node:path'
import committed from '../hard/fingerprint.json'
import { fingerprintScript } from '../hard/bundle.ts'
import { inEach } from './inEach.ts'

const bundle = await fingerprintScript()

inEach((tab, open) => {
  test.each([1440, 768, 390])(
    'at %d px nothing scrolls sideways and nothing is said',
    async (width) => {
      await open('', width)
      expect(
        await tab().run(() => document.documentElement.scrollWidth - innerWidth),
      ).toBeLessThanOrEqual(0)
      expect(await tab().run(() => window.problems)).toEqual([])
    },
  )

  test('the physics computes the same bits as Node, in the page and in a worker', async () => {
    await open()
    const { script, expression } = bundle
    const inPage = await tab().run(
      // A function's own name is not global, so that the page keeps none of it.
      (text) => new Function(text)() as string,
      `${script}\nreturn ${expression}`,
    )
    expect(JSON.parse(inPage)).toEqual(committed)
    const inWorker = await tab().run(
      (text) =>
        new Promise<string>((resolve, reject) => {
          const worker = new Worker(URL.createObjectURL(new Blob([text])))
          worker.onmessage = ({ data }) => resolve(data as string)
          worker.onerror = ({ message }) => reject(new Error(message))
        }),
      `${script}\npostMessage(${expression})`,
    )
    expect(JSON.parse(inWorker)).toEqual(committed)
  })

  test('offline.html runs from a disk', async () => {
    const file = pathToFileURL(join(inject('folder'), 'offline.html')).href
    await tab().open(file, { width: 1280, height: 844 })
    await expect
      .poll(() => tab().run(() => document.querySelector('.spread output')?.textContent))
      .toMatch(/\d\sm/)
    expect(await tab().run(() => window.problems)).toEqual([])
  })

  test('embed.html runs in a sandboxed frame and says its height', async () => {
    await tab().open(new URL('sandbox.html', inject('address')).href, { width: 1280, height: 844 })
    const told = () => tab().run(() => (window as unknown as { told?: number }).told ?? 0)
    await expect.poll(told).toBeGreaterThan(300)
    expect(await tab().run(() => window.problems)).toEqual([])
  })

  test('the element runs in a plain page', async () => {
    await tab().open(new URL('plain.html', inject('address')).href, { width: 1280, height: 844 })
    const spread = () =>
      tab().run(
        () =>
          document.querySelector('slide-lab')!.shadowRoot?.querySelector('.spread output')
            ?.textContent ?? '',
      )
    await expect.poll(spread).toMatch(/\d\sm/)
    expect(await tab().run(() => window.problems)).toEqual([])
  })
})
