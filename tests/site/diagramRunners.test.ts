import type { Page } from 'playwright-core'
import { describe, expect, test } from 'vitest'
import { roughSize } from '../../src/chart/magnitudes.ts'
import { opening } from '../../src/lab/state/opening.ts'
import { presentationErrors, sweepRates, sweepTolerances } from '../../src/measure/index.ts'
import { simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { shared, openMeasures, press } from './measurePage.ts'

describe('the runners of the lab in the diagram', () => {
  const rings = (page: Page) =>
    page.locator('slide-speed-diagram .ring').evaluateAll((all) =>
      all.map((each) => {
        const circle = each.querySelector('circle:not(.halo)')!
        return {
          x: Number(circle.getAttribute('cx')),
          y: Number(circle.getAttribute('cy')),
          colour: getComputedStyle(circle).stroke,
          isDashed: getComputedStyle(circle).strokeDasharray !== 'none',
        }
      }),
    )
  const ringKey = (page: Page) =>
    page
      .locator('slide-speed-diagram .ring-key')
      .innerText()
      .then((text) => text.replace(/\s+/g, ' '))

  test('have a ring each, in words and in the table too, and follow the lab', async () => {
    const lab = await openMeasures()
    await lab.ready()
    const sizes = opening.runners.map(({ frames, timestep, integrator, stopping }) => {
      const method = { frames, timestep, integrator, stopping }
      return roughSize(presentationErrors(simulate({ ...shared, ...method } as Experiment)).largest)
    })
    await expect.poll(() => rings(lab.page)).toHaveLength(3)
    // They clamp, the curves locate.
    expect((await rings(lab.page)).every(({ isDashed }) => isDashed)).toBe(true)
    expect(new Set((await rings(lab.page)).map(({ colour }) => colour)).size).toBe(3)
    const words = await ringKey(lab.page)
    for (const [i, fps] of [10, 30, 120].entries())
      expect(words).toContain(`${fps} fps ${sizes[i]!.replace(/\s/g, ' ')}`)
    expect(words).toContain('Dashed')
    await lab.page.locator('slide-speed-diagram summary').click()
    const row = lab.page
      .locator('slide-speed-diagram tbody tr')
      .nth(sweepRates.length + sweepTolerances.length)
    expect(await row.locator('th').innerText()).toMatch(/^10 fps\s+in the lab$/)
    expect(await row.locator('td').nth(1).innerText()).toContain(sizes[0]!)
    expect(await row.locator('td').nth(0).innerText()).toBe('')

    // The curves clamp too: each ring is around a point of its method's curve.
    await lab.page
      .getByRole('combobox', { name: 'Stopping rule of the diagram' })
      .selectOption('clamped')
    await expect
      .poll(async () => (await rings(lab.page)).map(({ isDashed }) => isDashed))
      .toEqual([false, false, false])
    await lab.ready()
    const marks = await lab.page
      .locator('slide-speed-diagram [data-method=semi-implicit-euler] .mark')
      .evaluateAll((all) =>
        all.map((mark) => {
          const { e: x, f: y } = (mark as SVGGraphicsElement).transform.baseVal.getItem(0).matrix
          return { x, y }
        }),
      )
    for (const [i, rate] of [10, 30, 120].entries())
      await expect
        .poll(async () => {
          const { x, y } = (await rings(lab.page))[i]!
          const mark = marks[sweepRates.indexOf(rate)]!
          return Math.max(Math.abs(x - mark.x), Math.abs(y - mark.y))
        })
        // Drawn to a hundredth of a pixel.
        .toBeLessThan(0.02)

    await lab.page.getByRole('button', { name: 'Hide 10 fps' }).click()
    await expect.poll(() => rings(lab.page)).toHaveLength(2)
    expect(await ringKey(lab.page)).not.toContain('10 fps')
    expect(lab.problems).toEqual([])
  })

  test('are read by keys, and are in the lab already', async () => {
    const lab = await openMeasures()
    await lab.ready()
    await lab.area.focus()
    await press(lab.page, 'ArrowRight', 'ArrowUp', 'Home', 'ArrowRight')
    expect(await lab.readOut()).toMatch(/^30 fps in the lab, Semi-implicit Euler: never off by /)
    expect(await lab.page.locator('slide-speed-diagram output').textContent()).toMatch(
      /^30 fps in the lab, Semi-implicit Euler: never off by .* evaluations a second\.$/,
    )
    await press(lab.page, 'Enter')
    expect(await lab.state()).toEqual(opening)
    expect(lab.problems).toEqual([])
  })

  test('have none where they are not measured as the curves are, and it is said why', async () => {
    const address =
      'runners=10;30;jitter(fps:30,amount:0.5,seed:1)/rk4;60/per-frame(step:1/50);60/clamped'
    const lab = await openMeasures(address)
    await lab.ready()
    await expect.poll(() => rings(lab.page)).toHaveLength(3)
    const words = await ringKey(lab.page)
    expect(words).toContain('no ring: its steps differ in length')
    expect(words).toContain('no ring: its seconds are not real seconds')
    await lab.view('Time on this device')
    await expect.poll(() => rings(lab.page), { timeout: 20_000 }).toHaveLength(2)
    expect(await ringKey(lab.page)).toContain('no ring: its time is not taken')
    expect(lab.problems).toEqual([])
  })
})
