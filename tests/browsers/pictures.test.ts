import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { PNG } from 'pngjs'
import { expect, test } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import { Picture } from '../site/picture.ts'
import type { Tab } from './engines/engine.ts'
import { inEach } from './inEach.ts'

/*
 * The lab and the controls of figures as each engine drew them when somebody last looked. Each is compared with itself,
 * since engines draw letters and edges each in its own way. `PICTURES=renew npm run test:browsers` takes them anew.
 */
const folder = join(import.meta.dirname, 'pictures')
const renew = process.env.PICTURES === 'renew'

/** They are kept this much smaller, each pixel the mean of a square: edges of letters then count for little [px]. */
const SQUARE = 6
/** Of a channel, so that files are small and rounding is not seen [1/255]. */
const LEVEL = 16
/** What an eye sees as different [1/255 of a channel]. */
const VISIBLE = 32
/** A button that is missing is some 25 squares of 16 000. */
const MOST = 1e-3

/** A figure with each kind of control: choices and sliders, a button of its own, switches, the recorder, the transport. */
const figures = [
  'area-under-v',
  'where-does-it-stop',
  'paper-step',
  'your-frames',
  'half-pipe-energy',
]

inEach((tab, open, engine) => {
  const looksAsItDid = async (name: string, selector: string) => {
    const shot = await settled(tab(), selector)
    const file = join(folder, engine.toLowerCase(), `${name}.png`)
    if (renew) {
      mkdirSync(join(folder, engine.toLowerCase()), { recursive: true })
      writeFileSync(file, shot)
    }
    expect(existsSync(file), `there is no ${file}: PICTURES=renew takes it`).toBe(true)
    const share = new Picture(shot).differing(new Picture(readFileSync(file)), VISIBLE)
    expect(share, `share of squares that differ from ${file}`).toBeLessThan(MOST)
  }

  test.each(scenes.map(({ id }) => id))('the scene %s looks as it did', async (id) => {
    await open(id === 'ramp' ? '' : `#scene=${id}`, 720)
    await tab().run(() => {
      const lab = document.querySelector('slide-lab')!
      // Ends the opening, which plays where motion is welcome.
      lab.dispatchEvent(new Event('wheel'))
      lab.scrollIntoView()
    })
    await looksAsItDid(id, 'slide-lab')
  })

  test('the controls of figures look as they did', async () => {
    await open('', 720)
    for (const name of figures) {
      const selector = `slide-figure[name="${name}"] .below`
      await expect
        .poll(() =>
          tab().run(
            (name, selector) => {
              document.querySelector(`slide-figure[name="${name}"]`)!.scrollIntoView()
              const below = document.querySelector(selector)
              below?.scrollIntoView({ block: 'center' })
              return below !== null
            },
            name,
            selector,
          ),
        )
        .toBe(true)
      await looksAsItDid(name, selector)
    }
  })
})

/** What of an element is in the window, small, once two pictures in a row are the same. */
async function settled(tab: Tab, selector: string): Promise<Buffer> {
  let last: Buffer | undefined
  await expect
    .poll(
      async () => {
        const { left, top, width, height } = await tab.run((selector) => {
          const box = document.querySelector(selector)!.getBoundingClientRect()
          const top = Math.max(0, Math.ceil(box.top))
          const bottom = Math.min(innerHeight, Math.floor(box.bottom))
          const left = Math.ceil(box.left)
          return { left, top, width: Math.floor(box.width), height: bottom - top }
        }, selector)
        const shot = small(PNG.sync.read(await tab.shoot()), { left, top, width, height })
        const same = last !== undefined && new Picture(last).differing(new Picture(shot), VISIBLE)
        last = shot
        return same
      },
      { timeout: 60_000, interval: 500 },
    )
    .toBe(0)
  return last!
}

/** A part of a picture in squares: the mean of each, to so many levels. */
function small(
  picture: PNG,
  { left, top, width, height }: { left: number; top: number; width: number; height: number },
): Buffer {
  const reduced = new PNG({
    width: Math.floor(width / SQUARE),
    height: Math.floor(height / SQUARE),
  })
  for (let y = 0; y < reduced.height; y++)
    for (let x = 0; x < reduced.width; x++)
      for (let channel = 0; channel < 4; channel++) {
        let sum = 0
        for (let i = 0; i < SQUARE * SQUARE; i++) {
          const column = left + SQUARE * x + (i % SQUARE)
          const row = top + SQUARE * y + Math.floor(i / SQUARE)
          sum += picture.data[4 * (picture.width * row + column) + channel]!
        }
        const mean = Math.min(255, LEVEL * Math.round(sum / SQUARE ** 2 / LEVEL))
        reduced.data[4 * (reduced.width * y + x) + channel] = channel === 3 ? 255 : mean
      }
  return PNG.sync.write(reduced, { colorType: 2 })
}
