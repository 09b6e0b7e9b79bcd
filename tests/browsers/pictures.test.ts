import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { Picture } from '../site/picture.ts'
import { inEach } from './inEach.ts'

/* How each engine drew the page when somebody last looked: `SHOTS=renew npm run test:browsers` draws it anew. */

/** What an eye sees as different [1/255 of a channel]. */
const VISIBLE = 24

const scenes = ['fall', 'ramp', 'run-out', 'half-pipe', 'spring', 'crest', 'belt']

/** A figure with each kind of control: sliders, a choice, a switch, a recorder of frames. */
const controls = ['.slider', '.choice', '.toggle', 'frames-recorder']

inEach((tab, open, engine) => {
  const folder = join(import.meta.dirname, 'pictures', engine.toLowerCase())

  function expectSame(name: string, shot: Buffer): void {
    const file = join(folder, `${name}.png`)
    if (process.env.SHOTS === 'renew') {
      mkdirSync(folder, { recursive: true })
      writeFileSync(file, shot)
    }
    expect(existsSync(file), `there is no ${file}: SHOTS=renew npm run test:browsers`).toBe(true)
    const share = new Picture(shot).differing(new Picture(readFileSync(file)), VISIBLE)
    // Edges of letters differ between versions of an engine; a word that moved is ten times as much.
    expect(share, 'share of pixels that differ').toBeLessThan(2e-3)
  }

  test.each(scenes)('%s', async (scene) => {
    await open(`#scene=${scene}`, 768)
    expectSame(scene, await tab().shoot())
  })

  test.each(controls)('a figure with %s', async (control) => {
    await open('', 768)
    const place = () =>
      tab().run((control) => {
        const figures = [...document.querySelectorAll('slide-figure')]
        const found = figures.find((each) => each.querySelector(`.controls ${control}`))
        if (found) {
          found.querySelector('.controls')!.scrollIntoView({ block: 'center' })
          return true
        }
        // Each comes alive once it is near.
        const next = figures.find((each) => !each.hasAttribute('live'))
        next?.scrollIntoView({ block: 'center' })
        return false
      }, control)
    await expect.poll(place, { timeout: 60_000 }).toBe(true)
    await tab().run(() => new Promise<void>((done) => setTimeout(done, 1000)))
    await place()
    await tab().run(() => new Promise<void>((done) => setTimeout(done, 300)))
    expectSame(`figure ${control.replace('.', '')}`, await tab().shoot())
  })
})
