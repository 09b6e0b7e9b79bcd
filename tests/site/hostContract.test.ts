import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { LitElement } from 'lit'
import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import type { Manifest } from '../elements/manifest.ts'
import { builtElements, labMark, openAt, serve } from './hosts.ts'

/* The manifest against the elements themselves: what it says is there, and there is nothing that it does not say. */

const { modules } = JSON.parse(
  readFileSync(join(import.meta.dirname, '../../custom-elements.json'), 'utf8'),
) as Manifest
const declared = new Map(modules[0]!.declarations.map((each) => [each.tagName, each]))
const tags = ['slide-lab', 'slide-figure'] as const
const names = (list: readonly { name: string }[]) => list.map(({ name }) => name).sort()
const sorted = (list: Iterable<string>) => [...new Set(list)].sort()

const { module } = builtElements()

async function openHost(body: string) {
  const html = `<!doctype html><html lang="en"><title>Blog</title>
    <script type="module" src="slide-lab.js"></script>${body}</html>`
  const address = await serve((path) =>
    path === 'lab.js'
      ? labMark
      : path === 'slide-lab.js'
        ? { body: module, type: 'text/javascript' }
        : { body: html },
  )
  const opened = await openAt(address)
  await opened.page.waitForFunction(() => customElements.get('slide-figure') !== undefined)
  return opened
}

test.each(tags)('attributes, properties and methods of %s', async (tag) => {
  const { page } = await openHost('')
  const found = await page.evaluate((tag) => {
    const of = customElements.get(tag) as typeof LitElement
    const element = document.createElement(tag)
    const options = [...of.elementProperties].map(([name, { state }]) => ({
      name: String(name),
      state: state === true,
    }))
    const kindOf = (name: string): string => {
      let at: object | null = element
      while (at && !Object.hasOwn(at, name)) at = Object.getPrototypeOf(at) as object | null
      const { get, set, value } = at ? Object.getOwnPropertyDescriptor(at, name)! : {}
      if (!at) return 'none'
      if (get && !set) return 'read'
      return typeof value === 'function' ? 'method' : 'field'
    }
    const own = Object.getOwnPropertyNames(of.prototype)
    return {
      attributes: [...of.observedAttributes],
      hidden: options.filter(({ state }) => state).map(({ name }) => name),
      public: [...own, ...options.filter(({ state }) => !state).map(({ name }) => name)],
      kinds: Object.fromEntries(
        [...own, 'trajectories', 'playback', 'lit', 'set', 'compact', 'duration', 'name'].map(
          (name) => [name, kindOf(name)],
        ),
      ),
    }
  }, tag)
  const { attributes, members } = declared.get(tag)!
  expect(sorted(found.attributes)).toEqual(names(attributes))
  // What Lit calls, and what is the element's own affair.
  const inner = [
    ...[
      'constructor',
      'connectedCallback',
      'disconnectedCallback',
      'createRenderRoot',
      'shouldUpdate',
      'willUpdate',
    ],
    ...['update', 'updated', 'render', 'comeAlive', ...found.hidden],
  ]
  // What it has from its base, which has more that is nobody's business.
  const handed =
    tag === 'slide-lab'
      ? ['trajectories', 'playback']
      : ['trajectories', 'playback', 'set', 'duration']
  const open = [...found.public.filter((name) => !inner.includes(name)), ...handed]
  expect(sorted(open)).toEqual(names(members))
  for (const { name, kind, readonly } of members) {
    const is = found.kinds[name]!
    if (kind === 'method') expect(['method', 'field'], name).toContain(is)
    else if (name !== 'playback') expect(is, name).toBe(readonly ? 'read' : 'field')
  }
})

/** Everything that can be done with both, wrong things too. */
async function useAll(page: Page): Promise<void> {
  const whole = page.locator('#whole')
  await whole.locator('slide-lab-plots').waitFor()
  await whole.getByRole('button', { name: 'Located' }).click()
  await whole.getByRole('button', { name: 'To the start' }).click()
  await whole.getByRole('button', { name: 'Play' }).click()
  await page.locator('#moving').scrollIntoViewIfNeeded()
  await page.locator('#moving [live]').waitFor()
  await page.locator('#moving .controls').getByRole('slider').first().press('ArrowRight')
  await page.locator('#moving').getByRole('button', { name: 'Play' }).click()
  await page.locator('#still').scrollIntoViewIfNeeded()
  await page.locator('#still [live]').waitFor()
  await page.locator('#wrong').scrollIntoViewIfNeeded()
  await page.locator('#wrong').getByRole('alert').waitFor()
}

const all = `
  <slide-lab id="whole"></slide-lab><slide-lab compact fps="-1"></slide-lab>
  <slide-figure id="moving" name="falling-ball"></slide-figure>
  <slide-figure id="still" name="area-under-v"></slide-figure>
  <slide-figure id="wrong" name="none"></slide-figure>`

test('events, parts and slots', async () => {
  const { page } = await openHost(`<script>
      window.told = []
      const { dispatchEvent } = EventTarget.prototype
      EventTarget.prototype.dispatchEvent = function (event) {
        if (/^slide-(lab|figure)$/.test(this.localName)) told.push(this.localName + ' ' + event.type)
        return dispatchEvent.call(this, event)
      }
    </script>${all}`)
  await useAll(page)
  const found = await page.evaluate((tags) => {
    const { told } = window as unknown as { told: string[] }
    return tags.map((tag) => {
      const made = document.createElement(tag).shadowRoot!
      const roots = [...document.querySelectorAll(tag)].map((each) => each.shadowRoot!)
      return {
        events: told
          .filter((each) => each.startsWith(`${tag} `))
          .map((each) => each.split(' ')[1]!),
        parts: roots.flatMap((root) =>
          [...root.querySelectorAll('[part]')].map((each) => each.getAttribute('part')!),
        ),
        slots: [...made.querySelectorAll('slot')].map(({ name }) => name),
      }
    })
  }, tags)
  tags.forEach((tag, i) => {
    const { events, cssParts, slots } = declared.get(tag)!
    expect(sorted(found[i]!.events), tag).toEqual(names(events))
    expect(sorted(found[i]!.parts), tag).toEqual(names(cssParts))
    expect(sorted(found[i]!.slots), tag).toEqual(names(slots))
  })
})

test('a page can style every part', async () => {
  const parts = tags.flatMap((tag) =>
    names(declared.get(tag)!.cssParts).map((part) => `${tag}::part(${part})`),
  )
  const { page } = await openHost(
    `<style>${parts.join()} { outline: 3px solid rgb(1, 2, 3) }</style>${all}`,
  )
  await useAll(page)
  const bare = await page.evaluate((tags) => {
    const roots = [...document.querySelectorAll(tags.join())].map((each) => each.shadowRoot!)
    const parts = roots.flatMap((root) => [...root.querySelectorAll('[part]')])
    return parts.filter((each) => getComputedStyle(each).outlineColor !== 'rgb(1, 2, 3)').length
  }, tags)
  expect(bare).toBe(0)
})

test('style variables', async () => {
  const { page } = await openHost(
    `<style>slide-lab { --size: 20px; --font-controls: monospace; --ink: rgb(1, 2, 3) }</style>${all}`,
  )
  const { given, used } = await page.evaluate(() => {
    const [sheet] = document.querySelector('slide-lab')!.shadowRoot!.adoptedStyleSheets
    const rules = [...sheet!.cssRules].filter((rule) => rule instanceof CSSStyleRule)
    const host = rules.filter(({ selectorText }) => selectorText === ':host')
    return {
      given: host.flatMap(({ style }) =>
        [...style]
          .filter((name) => name.startsWith('--'))
          .map((name) => ({ name, value: style.getPropertyValue(name) })),
      ),
      used: [...sheet!.cssRules].map(({ cssText }) => cssText).join(''),
    }
  })
  // One that stands for another is only a shorter name.
  const open = given.filter(({ value }) => !value.trim().startsWith('var(')).map(({ name }) => name)
  for (const tag of tags) expect(sorted(open), tag).toEqual(names(declared.get(tag)!.cssProperties))
  // The canvas alone has these.
  const drawn = ['--force-other', '--force-sum', '--velocity']
  for (const name of open)
    if (!drawn.includes(name))
      expect(/--(runner|force)-/.test(name) || used.includes(`var(${name})`), name).toBe(true)
  const about = await page
    .locator('#whole .about')
    .first()
    .evaluate((element) => {
      const { fontSize, fontFamily } = getComputedStyle(element)
      return { fontSize, fontFamily }
    })
  // 0.875 of the size.
  expect(about).toEqual({ fontSize: '17.5px', fontFamily: 'monospace' })
})
