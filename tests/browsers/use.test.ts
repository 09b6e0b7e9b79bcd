import { expect, test } from 'vitest'
import type { LabState } from '../../src/lab/state/state.ts'
import type { Tab } from './engines/engine.ts'
import { inEach } from './inEach.ts'

/** Presses the button of that name, as assistive technology does. */
const press = (tab: Tab, name: string) =>
  tab.run((name) => {
    const buttons = [...document.querySelectorAll<HTMLElement>('button, [role="tab"]')]
    const button = buttons.find(
      (each) => (each.ariaLabel ?? each.textContent).trim().replace(/\s+/g, ' ') === name,
    )
    if (!button) throw new Error(`There is no button “${name}”.`)
    button.click()
  }, name)

const stateOf = (tab: Tab) =>
  tab.run(() => (document.querySelector('slide-lab') as unknown as { state: LabState }).state)

const textOf = (tab: Tab, selector: string) =>
  tab.run((selector) => document.querySelector<HTMLElement>(selector)?.innerText ?? '', selector)

inEach((tab, open) => {
  test.each([
    ['tilt', 'angle'],
    ['place', 'position'],
    ['push', 'speed'],
  ])('the handle %s is dragged', async (handle, parameter) => {
    await open()
    const at = await tab().run((handle) => {
      const element = document.querySelector(`[data-handle="${handle}"]`)!
      element.scrollIntoView({ block: 'center' })
      const { x, y, width, height } = element.getBoundingClientRect()
      return { x: Math.round(x + width / 2), y: Math.round(y + height / 2) }
    }, handle)
    const before = await stateOf(tab())
    await tab().drag(at, { x: at.x + 8, y: at.y - 8 }, { x: at.x + 25, y: at.y - 25 })
    const after = await stateOf(tab())
    expect(after.parameters[parameter]).not.toBe(before.parameters[parameter])
    // The others are where they were.
    expect({ ...after.parameters, [parameter]: 0 }).toEqual({
      ...before.parameters,
      [parameter]: 0,
    })
    await expect.poll(() => tab().run(() => location.hash)).toContain(parameter)
  })

  test('a button mends the runners, and it is undone and redone', async () => {
    await open()
    const spread = () => textOf(tab(), '.spread output')
    // The opening plays once where motion is welcome, and counts up.
    await expect.poll(spread).toBe('0.23\u202fm')
    const before = await spread()
    await press(tab(), 'Located')
    await expect.poll(spread).not.toBe(before)
    const mended = await spread()
    await press(tab(), 'Undo')
    await expect.poll(spread).toBe(before)
    await press(tab(), 'Redo')
    await expect.poll(spread).toBe(mended)
  })

  test('a tab opens another scene', async () => {
    await open()
    await tab().run(() =>
      document.querySelector<HTMLInputElement>('.scenes input[value="half-pipe"]')!.click(),
    )
    await expect.poll(async () => (await stateOf(tab())).scene).toBe('half-pipe')
    await expect.poll(() => tab().run(() => location.hash)).toContain('half-pipe')
  })

  test('time runs, halts and goes back', async () => {
    await open()
    const time = () =>
      tab().run(
        () =>
          (document.querySelector('slide-lab') as unknown as { playback: { time: number } })
            .playback.time,
      )
    await press(tab(), 'To the start')
    expect(await time()).toBe(0)
    await press(tab(), 'Play')
    await expect.poll(time).toBeGreaterThan(0.1)
    await press(tab(), 'Pause')
    const halted = await time()
    await press(tab(), 'One frame back')
    expect(await time()).toBeLessThan(halted)
  })

  test('a preset is loaded, and Share has its address', async () => {
    await open()
    await tab().run(() => {
      const menu = document.querySelector<HTMLSelectElement>('select.presets')!
      menu.selectedIndex = 3
      menu.dispatchEvent(new Event('change', { bubbles: true }))
    })
    await expect.poll(() => tab().run(() => location.hash.length)).toBeGreaterThan(5)
    await press(tab(), 'Share')
    await expect.poll(() => textOf(tab(), 'slide-share-menu')).toContain('Copy link')
  })

  test('plots are drawn and measures come from a worker', async () => {
    await open()
    await tab().run(() => document.querySelector('slide-lab-plots')!.scrollIntoView())
    const painted = () =>
      tab().run(() => {
        const canvas = document.querySelector<HTMLCanvasElement>('slide-lab-plot canvas')
        if (!canvas || canvas.width === 0) return false
        const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height)
        return data.some((value) => value !== 0)
      })
    // A plot of vectors has its curves as paths.
    const drawn = async () =>
      (await painted()) ||
      (await tab().run(() => document.querySelectorAll('slide-lab-plot path').length > 1))
    await expect.poll(drawn).toBe(true)
    await tab().run(() => document.querySelector('slide-lab-measures')!.scrollIntoView())
    await expect
      .poll(
        () =>
          tab().run(() => {
            const view = document.querySelector(
              'slide-speed-diagram, slide-rate-map, slide-spread-view',
            )
            const { measuring } = (view ?? {}) as { measuring?: { busy: boolean; done: number } }
            return measuring !== undefined && !measuring.busy && measuring.done === 1
          }),
        { timeout: 60_000 },
      )
      .toBe(true)
    expect(await tab().run(() => window.problems)).toEqual([])
  })

  test('a figure comes alive, and its numbers follow its sliders', async () => {
    await open()
    await tab().run(() =>
      document.querySelector('slide-figure')!.scrollIntoView({ block: 'center' }),
    )
    const figure = 'slide-figure[live]:has(.slider input)'
    await expect
      .poll(() => tab().run((figure) => document.querySelector(figure) !== null, figure))
      .toBe(true)
    const said = () => textOf(tab(), `${figure} .slider output`)
    const before = await said()
    await tab().run((figure) => {
      const slider = document.querySelector<HTMLInputElement>(`${figure} .slider input`)!
      slider.value = slider.max
      slider.dispatchEvent(new Event('input', { bubbles: true }))
    }, figure)
    await expect.poll(said).not.toBe(before)
  })
})
