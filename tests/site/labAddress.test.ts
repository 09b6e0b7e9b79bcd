import { expect, test } from 'vitest'
import { openLab } from './labPage.ts'

test('the address holds what differs from the opening, and a reload brings it back', async () => {
  const lab = await openLab()
  const { page } = lab
  await lab.slider('Angle').fill('20')
  await page.getByRole('button', { name: 'Located' }).click()
  await lab.address(/^#angle=20&runners=10;30;120$/)
  const state = await lab.state()
  await page.reload()
  await expect.poll(lab.state).toEqual(state)
  expect(
    await page.locator('slide-lab').getByRole('button', { pressed: true }).allInnerTexts(),
  ).toEqual(['Located'])
  await page.getByRole('button', { name: 'Reset Angle' }).click()
  await page.getByRole('button', { name: 'Clamped' }).click()
  await lab.address(/^$/)
})

test('a change is written at once, and the last of many soon after', async () => {
  const lab = await openLab()
  const hash = () => lab.page.evaluate(() => location.hash)
  await lab.slider('Angle').fill('33')
  expect(await hash()).toBe('#angle=33')
  for (const angle of [34, 35, 36, 37]) await lab.slider('Angle').fill(String(angle))
  await lab.address(/^#angle=37$/)
})

test('back and forward, and a link in the page, bring their states', async () => {
  const lab = await openLab('angle=20')
  const { page } = lab
  const angle = async () => (await lab.state()).parameters.angle
  await lab.goTo('#angle=40')
  expect(await angle()).toBe(40)
  await page.goBack()
  await expect.poll(angle).toBe(20)
  await page.goForward()
  await expect.poll(angle).toBe(40)
  expect(lab.problems).toEqual([])
})

test('a link to a place in the page leaves the lab as it is', async () => {
  const lab = await openLab('angle=20')
  await lab.page.getByRole('link', { name: 'Source' }).click()
  expect((await lab.state()).parameters.angle).toBe(20)
  expect(await lab.page.getByRole('alert').count()).toBe(0)
  await lab.address(/^#angle=20$/)
})

test('a bad link shows every problem, as text, above a lab that works', async () => {
  const lab = await openLab(
    'angle=200&speeed=3&runners=10;<img src=x onerror=alert(1)>;30/fixed(step:0)',
  )
  const { page } = lab
  const alert = page.getByRole('alert')
  const text = await alert.innerText()
  expect(text).toContain('parameters.angle: 200 is not in 0…90')
  expect(text).toContain('parameters.speeed: is not known here; did you mean speed?')
  expect(text).toContain('runners[1]: "<img src=x onerror=alert(1)>" is neither')
  expect(text).toContain('runners[2].timestep.step: 0 is not in')
  expect(await alert.locator('img').count()).toBe(0)
  const [above, sheet] = [await alert.boundingBox(), await page.locator('.sheet').boundingBox()]
  expect(above!.y + above!.height).toBeLessThanOrEqual(sheet!.y)
  expect(await lab.spread()).toBe('0.23\u202fm')
  await lab.slider('Angle').fill('20')
  expect(await alert.count()).toBe(0)
  await lab.address(/^#angle=20$/)
  expect(lab.problems).toEqual([])
})

test('a link typed over a good one is told to be bad, and the next good one is taken', async () => {
  const lab = await openLab('angle=20')
  await lab.goTo('#scene=rampp')
  expect(await lab.page.getByRole('alert').innerText()).toContain('scene: "rampp" is not one of')
  await lab.goTo('#scene=fall')
  expect(await lab.page.getByRole('alert').count()).toBe(0)
  expect((await lab.state()).scene).toBe('fall')
})

test('nothing from an address reaches the page as HTML', async () => {
  const markup = '<img src=x onerror="document.title=1"><b id=smuggled>'
  const { page, goTo, problems } = await openLab()
  for (const where of [
    `angle=${markup}`,
    `${markup}=1`,
    `runners=${markup}`,
    `runners=10/fixed(step:${markup})`,
    `scene=${markup}`,
    `duration=${markup}`,
  ]) {
    // Both as it stands and as a browser writes it.
    for (const hash of [where, encodeURI(where)]) {
      await goTo('#scene=ramp')
      await page.getByRole('alert').waitFor({ state: 'detached' })
      await goTo(`#${hash}`)
      await page.getByRole('alert').waitFor()
      expect(await page.getByRole('alert').innerText()).toContain('<img src')
      expect(await page.locator('#smuggled, img').count()).toBe(0)
      expect(await page.title()).toBe('Any Frame Rate')
      expect(problems).toEqual([])
    }
  }
})
