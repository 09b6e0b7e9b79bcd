import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import type { SlideFigureElement } from '../../src/elements.ts'
import { framesAsked } from './frames.ts'
import { figure, lab, openHost, spread } from './hostPage.ts'
import { builtElements, labMark, openAt, serve } from './hosts.ts'

/* The elements in pages of plain HTML: whatever those do, both go on as they were. */

const { module } = builtElements()

test.each(['before', 'after'])('the module %s the markup', async (where) => {
  const head = where === 'before' ? '<script type="module" src="slide-lab.js"></script>' : ''
  const { page, problems } = await openHost(lab + figure, { head })
  await page.locator('slide-figure [live]').waitFor()
  expect(await spread(page)).toBe('0.23\u202fm')
  expect(problems()).toEqual([])
})

test.each(['README.md', 'docs/embedding.md'])('the example in %s', async (name) => {
  const text = readFileSync(join(import.meta.dirname, '../..', name), 'utf8')
  const [, example] = /```html\n([^]*?slide-figure[^]*?)```/.exec(text)!
  const { page, problems } = await openHost(example!)
  await page.locator('slide-figure [live]').waitFor()
  await page.locator('slide-lab [part=link]').waitFor()
  expect(await page.getByText('Fig. 1').isVisible()).toBe(true)
  expect(await page.getByRole('alert').count()).toBe(0)
  expect(problems()).toEqual([])
})

const wrong: Readonly<Record<string, readonly (readonly [attribute: string, value: string])[]>> = {
  'slide-lab compact': [
    ['experiment', '{'],
    ['experiment', '[]'],
    ['experiment', '{"scene":"ramp","parameters":{"angle":"steep"}}'],
    ['scene', 'moon'],
    ['fps', 'fast'],
    ['fps', '1 2 3 4 5 6 7 8 9'],
    ['integrator', 'euler'],
    ['stopping', 'never'],
    ['timestep', 'fixd'],
    ['timestep', '{"kind":"fixed","step":-1}'],
    ['duration', '-1'],
  ],
  'slide-figure name="area-under-v"': [
    ['values', '{'],
    ['values', '5'],
    ['values', '{"step":"long"}'],
  ],
  'slide-figure': [['name', 'nobody']],
}

test.each(Object.entries(wrong))(
  'what %s can’t have is told of, in each element and by an event of each',
  async (start, attributes) => {
    const [tag] = start.split(' ')
    const body = attributes.map(([name, value]) => `<${start} ${name}='${value}'></${tag}>`)
    const { page, problems } = await openHost(body.join(''), {
      head: `<script>
        window.told = []
        addEventListener('error', ({ target, detail }) => told.push([target, detail.message]), true)
      </script>`,
    })
    type Told = [target: Element, message: string][]
    for (const [i, [name]] of attributes.entries()) {
      const element = page.locator(tag!).nth(i)
      await element.scrollIntoViewIfNeeded()
      const alert = element.getByRole('alert')
      await alert.waitFor()
      const told = () =>
        element.evaluate((element) =>
          (window as unknown as { told: Told }).told
            .filter(([target]) => target === element)
            .map(([, message]) => message),
        )
      await expect.poll(told).toHaveLength(1)
      const [message] = await told()
      expect(message!.length).toBeGreaterThan(15)
      expect(await alert.innerText()).toContain(message!.split('\n')[0])
      if (tag === 'slide-lab') expect(message).toMatch(new RegExp(`^${name}`))
      // What there is without it is there.
      if (name !== 'name') expect(await element.locator('canvas').first().isVisible()).toBe(true)
    }
    expect(problems()).toEqual([])
  },
)

test('what stands between the tags is there until the elements are, and captions stay', async () => {
  let letGo = () => {}
  const held = new Promise<void>((done) => (letGo = done))
  const inside = (tag: string, more: string) =>
    `<${tag} ${more}><p>Instead of ${tag}</p><p slot="caption">Under ${tag}</p></${tag}>`
  const address = await serve(async (path) => {
    if (path === 'lab.js') return labMark
    if (path !== 'slide-lab.js')
      return {
        body: `<!doctype html><title>Blog</title><script type="module" src="slide-lab.js"></script>
          ${inside('slide-lab', 'compact')}<div style="height: 300vh"></div>${inside('slide-figure', 'name="area-under-v"')}`,
      }
    await held
    return { body: module, type: 'text/javascript' }
  })
  const opening = openAt(address)
  // The page is not loaded before its module is.
  setTimeout(letGo, 300)
  const { page, problems } = await opening
  const seen = (text: string) => page.getByText(text).isVisible()
  await page.locator('slide-lab .sheet').waitFor()
  expect(await seen('Instead of slide-lab')).toBe(false)
  expect(await seen('Under slide-lab')).toBe(true)
  // Far from the window it is not alive.
  expect(await seen('Instead of slide-figure')).toBe(true)
  await page.locator('slide-figure').scrollIntoViewIfNeeded()
  await page.locator('slide-figure [live]').waitFor()
  expect(await seen('Instead of slide-figure')).toBe(false)
  expect(await seen('Under slide-figure')).toBe(true)
  expect(await page.locator('slide-figure').evaluate(({ children }) => children.length)).toBe(2)
  expect(problems()).toEqual([])
})

test('without scripts the page’s own words stand there', async () => {
  const { page } = await openHost('<slide-lab><p>A picture of it</p></slide-lab>', {
    javaScriptEnabled: false,
  })
  expect(await page.getByText('A picture of it').isVisible()).toBe(true)
})

test('many on a page: each is its own, and none works when nothing moves', async () => {
  const { page, problems } = await openHost(lab.repeat(10) + figure.repeat(10))
  await page.locator('slide-lab').nth(3).getByRole('button', { name: 'Located' }).click()
  await expect
    .poll(() => page.locator('slide-lab').nth(3).locator('.spread output').innerText())
    .toMatch(/^0/)
  expect(await spread(page)).toBe('0.23\u202fm')
  for (const each of await page.locator('slide-figure').all()) {
    await each.scrollIntoViewIfNeeded()
    await each.locator('[live]').waitFor()
  }
  await page.locator('slide-lab:not([gliding])').nth(9).waitFor()
  await expect.poll(() => framesAsked(page)).toBe(0)
  expect(problems()).toEqual([])
})

test('the module twice, from two places', async () => {
  const { page, problems } = await openHost(lab + figure, {
    head: '<script type="module" src="old/slide-lab.js"></script><script type="module" src="new/slide-lab.js?2"></script>',
  })
  await page.locator('slide-figure [live]').waitFor()
  expect(await spread(page)).toBe('0.23\u202fm')
  expect(problems()).toEqual([])
})

/** Whether a page's two elements can be seen, with their styles, and their pictures are as wide as they are. */
function areWhole(): boolean {
  const hosts = [...document.querySelectorAll<HTMLElement>('slide-lab, slide-figure')]
  return hosts.every(({ shadowRoot, clientWidth }) => {
    const canvas = shadowRoot!.querySelector('canvas')
    // The card's edge is 1 px.
    return clientWidth > 300 && canvas?.clientWidth === clientWidth - 2 && canvas.width > 300
  })
}

const places: readonly (readonly [string, string, () => void])[] = [
  [
    'moved elsewhere',
    '$',
    () => document.body.prepend(...document.querySelectorAll('[name], [compact]')),
  ],
  [
    'cloned',
    '<section>$</section>',
    () => {
      const section = document.querySelector('section')!
      section.replaceWith(section.cloneNode(true))
    },
  ],
  [
    'from a template',
    '<template>$</template>',
    () => document.body.append(document.querySelector('template')!.content.cloneNode(true)),
  ],
  [
    'in what was closed',
    '<details><summary>More</summary>$</details>',
    () => (document.querySelector('details')!.open = true),
  ],
  [
    'in a tab that was not displayed',
    '<section hidden>$</section>',
    () => (document.querySelector('section')!.hidden = false),
  ],
  [
    'in a place that had no width',
    '<section style="width: 0; overflow: hidden">$</section>',
    () => (document.querySelector('section')!.style.width = ''),
  ],
  [
    'moved into the page of a frame',
    '$<iframe style="width: 900px; height: 1500px"></iframe>',
    () =>
      document
        .querySelector('iframe')!
        .contentDocument!.body.append(...document.querySelectorAll('[name], [compact]')),
  ],
]

test.each(places)('%s, both are as anywhere', async (_, place, act) => {
  const { page, problems } = await openHost(place.replace('$', lab + figure), { height: 1600 })
  await page.waitForFunction(() => customElements.get('slide-figure') !== undefined)
  await page.evaluate(act)
  const where = page.frames().at(-1)!
  await where.locator('slide-figure [live] canvas').waitFor()
  expect(await where.locator('slide-lab, slide-figure').count()).toBe(2)
  await expect.poll(() => where.evaluate(areWhole)).toBe(true)
  expect(await where.locator('.spread output').innerText()).toBe('0.23\u202fm')
  expect(problems()).toEqual([])
})

test('what a figure is asked for may come in any order', async () => {
  const { page, problems } = await openHost('<main></main>')
  const state = (id: string) =>
    page.locator(`#${id}`).evaluate((element) => {
      const { values, shadowRoot } = element as unknown as SlideFigureElement
      return { values, alerts: shadowRoot!.querySelectorAll('[role=alert]').length }
    })
  await page.evaluate(async () => {
    await customElements.whenDefined('slide-figure')
    const add = (id: string, use: (figure: SlideFigureElement) => void) => {
      const figure = document.createElement('slide-figure') as SlideFigureElement
      figure.id = id
      use(figure)
      document.querySelector('main')!.append(figure)
    }
    add('unnamed', (figure) => figure.setAttribute('values', '{"step":0.3}'))
    add('changed', (figure) => {
      figure.name = 'area-under-v'
      figure.set({ step: 0.7 })
    })
  })
  await page.locator('#unnamed').getByRole('alert').waitFor()
  await page.locator('#unnamed').evaluate((figure) => figure.setAttribute('name', 'area-under-v'))
  const given = (step: number) => ({ alerts: 0, values: { step, method: 'semi-implicit-euler' } })
  await expect.poll(() => state('unnamed')).toEqual(given(0.3))
  await expect.poll(() => state('changed')).toEqual(given(0.7))
  expect(problems()).toEqual([])
})

test('elements of the page with everyday names are left alone', async () => {
  const names = [
    'share-menu',
    'runner-row',
    'frame-strip',
    'quantity-control',
    'figure-picture',
    'rate-map',
  ]
  const theirs = (names: string[]) => `
    for (const name of ${JSON.stringify(names)})
      customElements.define(name, class extends HTMLElement {
        connectedCallback() { this.textContent = 'theirs' }
      })`
  const { page, problems } = await openHost(
    `<slide-lab></slide-lab>${figure}${names.map((name) => `<${name}></${name}>`).join('')}`,
    { head: `<script>${theirs(names.slice(0, 3))}</script>` },
  )
  await page.locator('slide-lab').getByRole('button', { name: 'Share' }).click()
  await page.getByRole('button', { name: 'Copy link' }).waitFor()
  await page.addScriptTag({ content: theirs(names.slice(3)) })
  for (const name of names) expect(await page.locator(`body > ${name}`).innerText()).toBe('theirs')
  expect(problems()).toEqual([])
})
