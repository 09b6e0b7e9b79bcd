import { expect, test } from 'vitest'
import { builtElements, labMark, openAt, serve } from './hosts.ts'

/* A page that turns slides by keys, as decks and manuals do: it hears those that no control in the element uses. */

const { module } = builtElements()

async function openDeck() {
  const address = await serve((path) =>
    path === 'lab.js'
      ? labMark
      : path === 'slide-lab.js'
        ? { body: module, type: 'text/javascript' }
        : {
            body: `<!doctype html><html lang="en"><title>Deck</title><script>
              window.heard = []
              for (const type of ['keydown', 'keypress', 'keyup'])
                document.addEventListener(type, ({ key }) => heard.push(type + ' ' + key))
            </script><slide-lab></slide-lab><script type="module" src="slide-lab.js"></script></html>`,
          },
  )
  const { page, problems } = await openAt(address)
  const lab = page.locator('slide-lab')
  await lab.locator('slide-runner-row').first().waitFor()
  /** What the page hears of a key, by the key's name in each event. */
  const heard = async (key: string) => {
    await page.evaluate(() => ((window as unknown as { heard: string[] }).heard.length = 0))
    await page.keyboard.press(key)
    return page.evaluate(() => (window as unknown as { heard: string[] }).heard)
  }
  return { page, lab, heard, problems }
}

test('what a slider, a button, a menu and the transport use stays; the rest is heard', async () => {
  const { lab, heard, problems } = await openDeck()
  const controls = [
    [lab.getByRole('slider', { name: 'Tilt the track' }), ['ArrowLeft', 'PageDown', 'Home']],
    [lab.getByRole('slider', { name: 'Angle, slider' }), ['ArrowRight', 'ArrowUp', 'End']],
    [lab.getByRole('button', { name: 'Located' }), ['Enter', ' ', 'ArrowLeft', 'Home']],
    [lab.getByLabel('Integrator').first(), ['ArrowDown', 'r']],
  ] as const
  for (const [control, keys] of controls) {
    await control.focus()
    for (const key of keys) expect(await heard(key), key).toEqual([])
    expect(await heard('Escape')).toEqual(['keydown Escape', 'keyup Escape'])
    expect(await heard('F2')).toEqual(['keydown F2', 'keyup F2'])
  }
  // A letter is nothing to a button.
  await lab.getByRole('button', { name: 'Located' }).focus()
  expect(await heard('b')).toEqual(['keydown b', 'keypress b', 'keyup b'])
  await lab.evaluate((each) => (each as HTMLElement).focus())
  for (const key of ['ArrowLeft', ' ', 'Home']) expect(await heard(key), key).toEqual([])
  expect(await heard('PageDown')).toEqual(['keydown PageDown', 'keyup PageDown'])
  expect(problems()).toEqual([])
})

test('what is typed in a field stays, and commands of the page are heard', async () => {
  const { lab, heard } = await openDeck()
  const field = lab.locator('.parameters slide-quantity-control input[type=text]').first()
  await field.focus()
  for (const key of ['1', '.', '5', 'ArrowLeft', 'Backspace', 'Control+a', 'Enter'])
    expect(await heard(key), key).toEqual(key.startsWith('Control') ? heardOfControl : [])
  expect(await heard('Control+k')).toContain('keydown k')
  await heard('7')
  // It takes back what is typed.
  expect(await heard('Escape')).toEqual([])
  expect(await heard('Escape')).toEqual(['keydown Escape', 'keyup Escape'])
})

/** The key Control itself is no command. */
const heardOfControl = ['keydown Control', 'keyup Control']

test('Escape closes an open menu, and is the page’s when none is', async () => {
  const { lab, heard } = await openDeck()
  await lab.getByRole('button', { name: 'Share' }).click()
  expect(await heard('Escape')).toEqual([])
  expect(await heard('Escape')).toEqual(['keydown Escape', 'keyup Escape'])
})

test('what a control changes is heard as `change` above the element, and out of a shadow root', async () => {
  const { page, lab } = await openDeck()
  await page.evaluate(() => {
    const told: string[] = []
    Object.assign(window, { told })
    document.addEventListener('change', ({ target, bubbles, composed }) =>
      told.push(`${(target as Element).localName} ${bubbles} ${composed}`),
    )
    const article = document.body.appendChild(document.createElement('article'))
    article.attachShadow({ mode: 'open' }).append(document.querySelector('slide-lab')!)
    article.shadowRoot!.append(document.createElement('slide-figure'))
    article.shadowRoot!.querySelector('slide-figure')!.setAttribute('name', 'area-under-v')
  })
  const told = () => page.evaluate(() => (window as unknown as { told: string[] }).told)
  await lab.getByRole('button', { name: 'Located' }).click()
  await expect.poll(told).toEqual(['article true true'])
  const figure = page.locator('slide-figure')
  await figure.scrollIntoViewIfNeeded()
  await figure.getByRole('slider').last().press('ArrowRight')
  await expect.poll(told).toEqual(['article true true', 'article true true'])
})
