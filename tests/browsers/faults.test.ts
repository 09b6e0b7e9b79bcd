import { expect, test } from 'vitest'
import { inEach } from './inEach.ts'

inEach((tab, open) => {
  test('a link to the last section stays at it while the lab above grows', async () => {
    await open('#references')
    await tab().run(() => new Promise<void>((done) => setTimeout(done, 2000)))
    const top = await tab().run(
      () => document.querySelector('#references')!.getBoundingClientRect().top,
    )
    expect(Math.abs(top)).toBeLessThan(60)
  })

  test('what is drawn is light as soon as the page is to be printed', async () => {
    await open()
    const { before, now } = await tab().run(async () => {
      document.documentElement.dataset.theme = 'dark'
      await new Promise((done) => setTimeout(done, 500))
      const canvas = document.querySelector<HTMLCanvasElement>('slide-stage canvas')!
      const middle = () => {
        const pen = canvas.getContext('2d')!
        const { data } = pen.getImageData(0, 0, canvas.width, canvas.height)
        let ink = 0
        let painted = 0
        for (let i = 0; i < data.length; i += 4)
          if (data[i + 3]! > 200) {
            ink += data[i]! + data[i + 1]! + data[i + 2]!
            painted++
          }
        return ink / painted
      }
      const before = middle()
      dispatchEvent(new Event('beforeprint'))
      const now = middle()
      dispatchEvent(new Event('afterprint'))
      return { before, now }
    })
    expect(now).not.toBeCloseTo(before, 0)
  })

  test('the legend of a choice stands in the line of its buttons', async () => {
    await open()
    const isThere = () =>
      tab().run(() => {
        if (document.querySelector('slide-figure .choice')) return true
        // Each comes alive once it is near.
        document.querySelector('slide-figure:not([live])')?.scrollIntoView({ block: 'center' })
        return false
      })
    await expect.poll(isThere, { timeout: 60_000 }).toBe(true)
    const apart = await tab().run(() => {
      const choice = document.querySelector('slide-figure .choice')!
      const range = document.createRange()
      range.selectNodeContents(choice.querySelector('legend')!)
      const legend = range.getBoundingClientRect()
      const options = choice.querySelector('.options')!.getBoundingClientRect()
      return legend.top + legend.height / 2 - (options.top + options.height / 2)
    })
    expect(Math.abs(apart)).toBeLessThan(8)
  })

  test('number and unit are never parted', async () => {
    await open()
    expect(await tab().run(() => document.body.innerText.match(/\d\u2009\S+/)?.[0] ?? '')).toBe('')
  })

  test('no bracket of a formula lies on the sign before it', async () => {
    await open()
    const gap = await tab().run(() => {
      const formulas = [...document.querySelectorAll('.text p math')]
      const brackets = formulas.flatMap((each) => [...each.querySelectorAll('mo')])
      const gaps = brackets
        .filter((each) => each.textContent === '(' && each.parentElement!.previousElementSibling)
        .map((each) => {
          const range = document.createRange()
          range.selectNodeContents(each)
          const before = each.parentElement!.previousElementSibling!.getBoundingClientRect()
          return range.getBoundingClientRect().left - before.right
        })
      return Math.min(...gaps)
    })
    // Their boxes may touch; hung, the bracket is further left than it is wide, some 6 px.
    expect(gap).toBeGreaterThan(-2)
  })

  test('a number of the text has a true minus, and menus are as wide as what is chosen', async () => {
    await open()
    const dials = await tab().run(() =>
      [...document.querySelectorAll<HTMLInputElement>('.dial input')].map(({ value }) => value),
    )
    expect(dials.filter((each) => each.includes('-'))).toEqual([])
    expect(dials.some((each) => each.startsWith('−'))).toBe(true)
    const [steady, longest] = await tab().run(() => {
      const menu = document.querySelector<HTMLSelectElement>('.runner .clock select')!
      const alone = menu.cloneNode(true) as HTMLSelectElement
      alone.style.cssText = 'max-width: none; field-sizing: fixed'
      menu.after(alone)
      const widths = [menu, alone].map((each) => each.getBoundingClientRect().width)
      alone.remove()
      return widths
    })
    expect(steady).toBeLessThan(0.9 * longest!)
  })
})
