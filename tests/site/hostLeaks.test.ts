import { expect, test, vi } from 'vitest'
import { samples } from '../samples.ts'
import { builtElements, labMark, openAt, serve } from './hosts.ts'

/* Elements that a page adds and removes, over and over. */

const { module } = builtElements()

/**
 * Counts what would keep an element alive: what listens to things that last, what observes elements that are still
 * there, frames that are asked for, and workers. Put into the page before anything else; `held()` says what there is.
 */
const counting = `{
  const kinds = new Map()
  const hold = (kind, key, more, element) => {
    const known = kinds.get(kind) ?? new Map()
    kinds.set(kind, known)
    if (more) known.set(key, element && new WeakRef(element))
    else known.delete(key)
  }
  // An observer does not keep what it observes: that counts only while it is there.
  const count = (known) => [...known.values()].filter((ref) => !ref || ref.deref()).length
  window.held = () => Object.fromEntries([...kinds].map(([kind, known]) => [kind, count(known)]))
  const ids = new WeakMap()
  let last = 0
  const id = (object) => ids.get(object) ?? (ids.set(object, ++last), last)
  const lasts = (target) =>
    target === window || target === document || target === document.fonts || target instanceof MediaQueryList
  for (const [name, more] of [['addEventListener', true], ['removeEventListener', false]]) {
    const original = EventTarget.prototype[name]
    EventTarget.prototype[name] = function (type, listener, options) {
      const target = this ?? window
      const key = [id(target), type, listener && id(listener), Boolean(options?.capture ?? options)]
      if (listener && lasts(target)) hold('listeners', key.join(), more)
      return original.call(target, type, listener, options)
    }
  }
  for (const name of ['ResizeObserver', 'IntersectionObserver', 'MutationObserver']) {
    const { prototype } = window[name]
    const { observe, unobserve, disconnect } = prototype
    const observed = new WeakMap()
    const key = (observer, target) => id(observer) + ' ' + id(target)
    prototype.observe = function (target, options) {
      observed.set(this, (observed.get(this) ?? new Set()).add(key(this, target)))
      hold(name, key(this, target), true, target)
      return observe.call(this, target, options)
    }
    if (unobserve) prototype.unobserve = function (target) {
      observed.get(this)?.delete(key(this, target))
      hold(name, key(this, target), false)
      return unobserve.call(this, target)
    }
    prototype.disconnect = function () {
      for (const each of observed.get(this) ?? []) hold(name, each, false)
      observed.delete(this)
      return disconnect.call(this)
    }
  }
  const { requestAnimationFrame, cancelAnimationFrame, Worker } = window
  window.requestAnimationFrame = (callback) => {
    const request = requestAnimationFrame((now) => {
      hold('frames', request, false)
      callback(now)
    })
    hold('frames', request, true)
    return request
  }
  window.cancelAnimationFrame = (request) => {
    hold('frames', request, false)
    cancelAnimationFrame(request)
  }
  window.Worker = class extends Worker {
    constructor(...given) {
      super(...given)
      hold('workers', id(this), true)
    }
    terminate() {
      hold('workers', id(this), false)
      super.terminate()
    }
  }
}`

type Playing = HTMLElement & { playback: { toStart(): void; play(): void } }

test('many that have come, played and gone leave no more behind than the first few', async () => {
  const html = `<!doctype html><html lang="en"><title>Blog</title><script>${counting}</script>
    <div id="here"></div><script type="module" src="slide-lab.js"></script></html>`
  const address = await serve((path) =>
    path === 'lab.js'
      ? labMark
      : path === 'slide-lab.js'
        ? { body: module, type: 'text/javascript' }
        : { body: html },
  )
  const { page, problems } = await openAt(address)
  const session = await page.context().newCDPSession(page)
  await page.waitForFunction(() => customElements.get('slide-figure') !== undefined)

  const rounds = (count: number, html: string) =>
    page.evaluate(
      async ({ count, html }) => {
        const here = document.querySelector('#here')!
        const frame = () => new Promise(requestAnimationFrame)
        for (let i = 0; i < count; i++) {
          here.innerHTML = html
          await frame()
          for (const each of [...here.children] as Playing[]) {
            const last = '[part=modes] button:last-child'
            each.shadowRoot!.querySelector<HTMLElement>(last)?.click()
            each.playback.toStart()
            each.playback.play()
            // Moved while it plays.
            here.prepend(each)
          }
          await frame()
          here.replaceChildren()
        }
      },
      { count, html },
    )
  const small = '<slide-lab compact></slide-lab><slide-figure name="falling-ball"></slide-figure>'
  const large = '<slide-lab></slide-lab>'
  const left = async () => {
    // What was told to happen a little later has happened.
    await page.waitForTimeout(1000)
    for (let i = 0; i < 3; i++) await session.send('HeapProfiler.collectGarbage')
    const { nodes, jsEventListeners } = (await session.send('Memory.getDOMCounters')) as {
      nodes: number
      jsEventListeners: number
    }
    const { usedSize } = (await session.send('Runtime.getHeapUsage')) as { usedSize: number }
    const held = await page.evaluate(() =>
      (window as unknown as { held: () => Record<string, number> }).held(),
    )
    return { held, nodes, jsEventListeners, usedSize }
  }

  // Everything is loaded, and every list that is kept for good has its length.
  await rounds(10, small)
  await rounds(5, large)
  const before = await left()
  const [smallRounds, largeRounds] = [samples(60, 200), samples(8, 20)]
  await rounds(smallRounds, small)
  await rounds(largeRounds, large)
  // Not one in twenty is left.
  const few = (2 * smallRounds + largeRounds) / 20
  // What the last of them was about may hold it a little longer: what leaks stays.
  await vi.waitFor(async () => {
    const after = await left()
    const { IntersectionObserver: seenAfter = 0, ...heldAfter } = after.held
    const { IntersectionObserver: seenBefore = 0, ...heldBefore } = before.held
    expect(heldAfter).toEqual(heldBefore)
    // These are watched as long as they live.
    expect(seenAfter - seenBefore).toBeLessThan(few)
    // One that stays has more than a hundred nodes, dozens of listeners and 100 kB of runs.
    expect(after.nodes - before.nodes).toBeLessThan(100 * few)
    expect(after.jsEventListeners - before.jsEventListeners).toBeLessThan(24 * few)
    expect(after.usedSize - before.usedSize).toBeLessThan(1e5 * few)
  }, 30_000)
  expect(problems()).toEqual([])
}, 240_000)
