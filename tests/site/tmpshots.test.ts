import { test } from 'vitest'
import { openLab } from './labPage.ts'
test.each([[1440,'light'],[768,'light'],[390,'light'],[1440,'dark'],[390,'dark']] as const)('%i %s', async (width, colorScheme) => {
  const lab = await openLab('', { width, height: 1000, colorScheme })
  const menu = lab.page.getByRole('combobox', { name: 'Your engine', exact: true })
  await menu.selectOption({ label: 'Compare engines' })
  await menu.scrollIntoViewIfNeeded()
  await lab.page.waitForTimeout(800)
  await lab.page.locator('slide-lab').first().screenshot({ path: `/tmp/shot-${width}-${colorScheme}.png` })
})
