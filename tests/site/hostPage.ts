import type { Page } from 'playwright-core'
import { builtElements, labMark, openAt, serve } from './hosts.ts'

/* A page of plain HTML that has the elements in it. */

const { module } = builtElements()

type Options = Parameters<typeof openAt>[2] & { head?: string; root?: string }

/** A page of somebody else's, with the module below its text at `slide-lab.js`, and under any other name too. */
export async function openHost(body: string, { head = '', root = '', ...options }: Options = {}) {
  const html = `<!doctype html><html lang="de" ${root}><head><meta charset="utf-8"><title>Blog</title>${head}</head>
    <body>${body}<script type="module" src="slide-lab.js"></script></body></html>`
  const address = await serve((path) =>
    path === 'lab.js'
      ? labMark
      : path.endsWith('.js')
        ? { body: module, type: 'text/javascript' }
        : { body: html },
  )
  return openAt(address, [], options)
}

export const lab = '<slide-lab compact></slide-lab>'
export const figure = '<slide-figure name="area-under-v"></slide-figure>'
/** The text of the first lab's large number. */
export const spread = (page: Page) => page.locator('slide-lab .spread output').first().innerText()
