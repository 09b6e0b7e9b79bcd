import type { Page } from 'playwright-core'
import type { PlotDrawing } from '../../src/panels/plots/curves.ts'
import { boxOf } from '../../src/panels/plots/chart.ts'
import { openLab } from './labPage.ts'

/** A lab whose plots can be seen and are drawn. */
export async function openPlots(address = '', options: Parameters<typeof openLab>[1] = {}) {
  const lab = await openLab(address, options)
  const { page } = lab
  await page.locator('slide-lab-plots .multiples').evaluate((each) => each.scrollIntoView())
  await page.locator('slide-lab-plot[data-plot=position] canvas.chart').waitFor()
  const plot = (id: string) => page.locator(`slide-lab-plot[data-plot=${id}]`)
  return {
    ...lab,
    plot,
    area: (id: string) => plot(id).locator('.area'),
    values: (id: string) => plot(id).locator('.value').allInnerTexts(),
    /** What a plot draws. */
    drawing: (id: string) =>
      page.evaluate(
        (id) =>
          (
            document.querySelector(`slide-lab-plot[data-plot=${id}]`) as unknown as {
              drawing: { curves: PlotDrawing['curves'] }
            }
          ).drawing.curves,
        id,
      ),
    pixelsOf: (id: string, layer: string) =>
      plot(id)
        .locator(layer)
        .evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL()),
  }
}

/** Where a point stands in the window, given as parts of the box in which a plot has its curves. */
export async function at(page: Page, id: string, across: number, down = 0.5) {
  const area = (await page.locator(`slide-lab-plot[data-plot=${id}] .area`).boundingBox())!
  const { left, top, right, bottom } = boxOf(area.width, area.height)
  return {
    x: area.x + left + across * (right - left),
    y: area.y + top + down * (bottom - top),
  }
}
