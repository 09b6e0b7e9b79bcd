import type { Page } from 'playwright-core'
import { inject } from 'vitest'
import { builtElements, labMark } from './hosts.ts'
import { openPage } from './page.ts'

/* A page of somebody else's whose styles are for everything in it. */

const { module } = builtElements()

/** Styles of somebody who does not know what else will be in the page. */
const wild = `
  body { font: 20px/2 serif; letter-spacing: 2px; text-align: center; color: rgb(10, 20, 30) }
  * { box-sizing: content-box }
  button { background: rgb(255, 0, 0) !important; padding: 30px; border-radius: 0 }
  p, h2, label { margin: 50px; color: rgb(0, 128, 0) }
  input, svg, canvas { width: 100% }
  .sheet, .icon, .runners, .parameters { display: none !important }
`

/** A page that is not the lab's, with the elements' module at its head. */
export async function openHost(
  body: string,
  options: { colorScheme?: 'dark'; width?: number; beside?: boolean } = {},
) {
  const { beside = true } = options
  const opened = await openPage({ path: '404.html', ...options })
  const { page } = opened
  const host = new URL('blog/', inject('address')).href
  const html = `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Blog</title>
    <style>${wild}</style><script type="module" src="slide-lab.js"></script></head>
    <body><main><h1>Blog</h1><button>Theirs</button>${body}</main></body></html>`
  await page.route(`${host}**`, (route) =>
    route.request().url().endsWith('.js')
      ? route.fulfill({ contentType: 'text/javascript', body: module })
      : route.fulfill({ contentType: 'text/html', body: html }),
  )
  await page.route(`${host}lab.js`, (route) =>
    beside
      ? route.fulfill({ contentType: 'text/javascript', body: labMark.body })
      : route.fulfill({ status: 404, body: 'Nothing here' }),
  )
  await page.goto(host)
  return opened
}

export const lab = (page: Page) => page.locator('slide-lab')

/** The text of a lab's large number. */
export const spread = (page: Page) => lab(page).locator('.spread output').first().innerText()
