import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { figures } from '../../src/figures/index.ts'
import { tutorialArticle } from '../../src/tutorial/build/load.ts'

const root = join(import.meta.dirname, '../..')
const index = readFileSync(join(root, 'index.html'), 'utf8')
const ids = [...index.matchAll(/\sid="([^"]+)"/g)].map((match) => match[1]!)

// It throws with file and line for whatever in the text has to be mended.
const article = tutorialArticle(root, ids)

test('the text shows every figure that there is', () => {
  const shown = [...article.matchAll(/<slide-figure name="([^"]+)"/g)].map((match) => match[1])
  expect([...shown].sort()).toEqual(figures.map(({ id }) => id).sort())
})

test('every section is in the contents, in the order of the files', () => {
  const files = readdirSync(join(root, 'src/tutorial/text')).filter((name) => name.endsWith('.md'))
  const sections = [...article.matchAll(/<section id="([^"]+)"/g)].map((match) => match[1])
  expect(sections).toEqual(files.sort().map((name) => name.replace(/^\d+-|\.md$/g, '')))
  const contents = article.slice(0, article.indexOf('</nav>'))
  expect([...contents.matchAll(/href="#([^"]+)"/g)].map((match) => match[1])).toEqual(sections)
})

test('the same text makes the same page, bit for bit', () => {
  expect(tutorialArticle(root, ids)).toBe(article)
})
