import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, inject, it } from 'vitest'
import { openLab } from './labPage.ts'
import { Picture } from './picture.ts'

/**
 * The page as it looked when somebody last looked at it. `npm run shots` takes the pictures anew: look at them before
 * they are committed. README's picture is one of them.
 */
const folder = join(import.meta.dirname, 'shots')
/** What an eye sees as different [1/255 of a channel]. */
const VISIBLE = 24

const renew = process.env.SHOTS === 'renew'

const shots: {
  name: string
  address?: string
  width: number
  height: number
  scheme: 'light' | 'dark'
}[] = [
  { name: 'opening-light', width: 1440, height: 1000, scheme: 'light' },
  { name: 'opening-dark', width: 1440, height: 1000, scheme: 'dark' },
  { name: 'fall', address: 'scene=fall', width: 1024, height: 900, scheme: 'light' },
  { name: 'run-out', address: 'scene=run-out', width: 1024, height: 900, scheme: 'dark' },
  { name: 'half-pipe', address: 'scene=half-pipe', width: 1024, height: 900, scheme: 'light' },
  { name: 'spring', address: 'scene=spring', width: 1024, height: 900, scheme: 'dark' },
  { name: 'crest', address: 'scene=crest', width: 1024, height: 900, scheme: 'light' },
  { name: 'belt', address: 'scene=belt', width: 1024, height: 900, scheme: 'dark' },
  { name: 'phone-light', width: 390, height: 844, scheme: 'light' },
  { name: 'phone-dark', width: 390, height: 844, scheme: 'dark' },
]

// Another browser draws letters and edges its own way, so only the packaged one is held to the pictures.
describe.skipIf(!inject('packaged'))('the page looks as it did', () => {
  it.each(shots)('$name', async ({ name, address, width, height, scheme }) => {
    const { page, problems } = await openLab(address, {
      width,
      height,
      colorScheme: scheme,
      reducedMotion: 'reduce',
    })
    const shot = await page.screenshot({ animations: 'disabled', caret: 'hide' })
    const file = join(folder, `${name}.png`)
    if (renew) {
      mkdirSync(folder, { recursive: true })
      writeFileSync(file, shot)
    }
    expect(existsSync(file), `there is no ${file}: npm run shots takes it`).toBe(true)
    const share = new Picture(shot).differing(new Picture(readFileSync(file)), VISIBLE)
    // A letter's edge may be drawn otherwise on another processor; a word that moved is a hundred times as much.
    expect(share, 'share of pixels that differ: npm run shots, and look').toBeLessThan(1e-4)
    expect(problems).toEqual([])
  })
})
