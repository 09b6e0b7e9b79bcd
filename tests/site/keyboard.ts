import type { Page } from 'playwright-core'
import { expect } from 'vitest'

/** What has the focus: its name, where it is, and whether that can be seen. */
interface Focus {
  readonly name: string
  /** Whether the page has lost it. */
  readonly isBody: boolean
  /** Whether it, or what stands for it, has an outline and is in the window. */
  readonly isSeen: boolean
  /** Its part of the lab. */
  readonly part: string
}

const PARTS =
  '.page-head, .scenes, .tools, .modes, .preset-note, slide-stage, .transport, .forces, .parameters, .runners, slide-lab-plots, slide-lab-measures, slide-step-inspector, .tutorial'

export const focus = (page: Page): Promise<Focus> =>
  page.evaluate((parts) => {
    const element = document.activeElement as HTMLElement
    // A radio button is seen by its label, a text field by its frame.
    const shown = [element, element.closest('label'), element.closest('.field')].filter(Boolean)
    const outlined = shown.some((each) => {
      const { outlineStyle, outlineWidth } = getComputedStyle(each!)
      return outlineStyle !== 'none' && parseFloat(outlineWidth) > 0
    })
    const { top, bottom, width, height } = shown.at(-1)!.getBoundingClientRect()
    const inWindow = width > 0 && height > 0 && bottom > 0 && top < innerHeight
    const labels = (element as HTMLInputElement).labels
    const name =
      element.ariaLabel ??
      ([...(labels ?? [])].map((label) => label.innerText).join(' ') || element.innerText)
    const home = element.closest(parts)
    return {
      name: name.replace(/\s+/g, ' ').trim(),
      isBody: element === document.body,
      isSeen: outlined && inWindow,
      part: home ? (home.classList[0] ?? home.localName) : '',
    }
  }, PARTS)

/** Presses Tab until what has the focus is so called, and fails if it is lost or not seen on the way. */
export async function tabTo(page: Page, name: RegExp | string, key = 'Tab'): Promise<void> {
  const passed: string[] = []
  for (let i = 0; i < 150; i++) {
    await page.keyboard.press(key)
    const now = await focus(page)
    expect(now.isBody, `lost after ${passed.at(-1)}`).toBe(false)
    expect(now.isSeen, `${now.name} is not seen to have the focus`).toBe(true)
    if (typeof name === 'string' ? now.name === name : name.test(now.name)) return
    passed.push(now.name)
  }
  throw new Error(`Tab does not lead to ${String(name)}, only to ${passed.join(' | ')}`)
}

/** All that Tab leads to, from the top of the page to the end of the lab. */
export async function tour(page: Page): Promise<Focus[]> {
  const stops: Focus[] = []
  for (let i = 0; i < 250; i++) {
    await page.keyboard.press('Tab')
    const now = await focus(page)
    if (now.isBody || now.part === 'tutorial') return stops
    stops.push(now)
  }
  throw new Error('Tab does not come to an end')
}

/** Each once, in the order in which they come first. */
export const inOrder = (stops: readonly Focus[]) => [...new Set(stops.map(({ part }) => part))]
