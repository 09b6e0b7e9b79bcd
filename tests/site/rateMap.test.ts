import { describe, expect, test } from 'vitest'
import { opening } from '../../src/lab/state/opening.ts'
import { mappedExperiment, presentationErrors, rateAt, rowValue } from '../../src/measure/index.ts'
import type { MapRequest } from '../../src/measure/index.ts'
import { simulate } from '../../src/physics/index.ts'
import { ENGINES, openMeasures, press } from './measurePage.ts'

describe('the frame-rate map', () => {
  test('is single runs of simulate; a click loads the one under it', async () => {
    const lab = await openMeasures()
    await lab.view('Frame-rate map')
    await lab.ready()
    const read = await lab.page.evaluate(() => {
      const { cells } = document.querySelector('slide-rate-map') as unknown as {
        cells: {
          request: MapRequest
          cell: (column: number, row: number) => { kind: string; value: number }
        }
      }
      const places = [
        [0, 0],
        [80, 60],
        [33, 100],
        [159, 119],
      ] as const
      return {
        request: cells.request,
        cells: places.map(([column, row]) => ({ column, row, ...cells.cell(column, row) })),
      }
    })
    const { request } = read
    expect(request).toMatchObject({ parameter: 'angle', columns: 160, rows: 120 })
    for (const { column, row, kind, value } of read.cells) {
      expect(kind).toBe('measured')
      const { largest } = presentationErrors(simulate(mappedExperiment(request, column, row)))
      expect(Math.abs(value - largest)).toBeLessThan(ENGINES)
    }
    const canvas = (await lab.page.locator('slide-rate-map canvas').boundingBox())!
    await lab.page.mouse.click(
      canvas.x + ((40 + 0.5) / 160) * canvas.width,
      canvas.y + canvas.height - ((90 + 0.5) / 120) * canvas.height,
    )
    await expect.poll(async () => (await lab.state()).parameters.angle).toBe(rowValue(request, 90))
    expect((await lab.state()).runners[0]!.frames).toEqual({
      kind: 'steady',
      fps: rateAt(request, 40),
    })
    await lab.page.getByRole('button', { name: 'Undo' }).click()
    expect(await lab.state()).toEqual(opening)
    expect(lab.problems).toEqual([])
  })

  test('is read by keys, has a table, and a legend for what blew up', async () => {
    const lab = await openMeasures('scene=spring&muStatic=0&muKinetic=0&runners=30/located')
    await lab.view('Frame-rate map')
    await lab.ready()
    expect(await lab.page.locator('slide-rate-map .limit').count()).toBe(1)
    expect(await lab.page.locator('.map-legend').innerText()).toContain('blew up')
    expect(await lab.readOut()).toMatch(/^Of all runs, .* blows up/)
    await lab.area.focus()
    await press(lab.page, 'ArrowUp', 'Shift+ArrowLeft')
    expect(await lab.readOut()).toMatch(/fps, stiffness \d+\u202fN\/m: the run /)
    await press(lab.page, 'Enter')
    await expect.poll(async () => (await lab.state()).parameters.stiffness).toBeGreaterThan(1000)
    await lab.page.locator('slide-rate-map summary').click()
    await lab.page.locator('slide-rate-map table').waitFor()
    expect(await lab.page.locator('slide-rate-map tbody tr').count()).toBe(6)
    expect(await lab.page.locator('slide-rate-map tbody td').count()).toBe(48)
    expect(lab.problems).toEqual([])
  })

  test('of another parameter, another method, and of the spread', async () => {
    const lab = await openMeasures()
    await lab.view('Frame-rate map')
    await lab.ready()
    await lab.page.getByRole('combobox', { name: 'Parameter of the map' }).selectOption('speed')
    await lab.page
      .getByRole('combobox', { name: 'Integrator of the map' })
      .selectOption('velocity-verlet')
    await lab.page
      .getByRole('combobox', { name: 'Stopping rule of the map' })
      .selectOption('located')
    await expect
      .poll(lab.readOut, { timeout: 20_000 })
      .toBe('Of all runs, 100\u202f% is exact to rounding.')
    // Its colour is the one that the legend says.
    const [painted, told] = await lab.page.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('slide-rate-map canvas')!
      const [r, g, b] = canvas.getContext('2d')!.getImageData(80, 60, 1, 1).data
      const swatch = document.querySelector('slide-rate-map .swatch[data-kind=rounding]')!
      return [`rgb(${r}, ${g}, ${b})`, getComputedStyle(swatch).backgroundColor]
    })
    expect(painted).toBe(told)
    await lab.view('Spread against 60 fps')
    await expect
      .poll(lab.readOut, { timeout: 20_000 })
      .toBe('Of all runs, 100\u202f% ends the same to rounding.')
    await lab.page.getByRole('combobox', { name: 'Time step of the map' }).selectOption('fixed')
    await expect.poll(lab.readOut, { timeout: 20_000 }).not.toContain('100')
    expect(lab.problems).toEqual([])
  })
})
