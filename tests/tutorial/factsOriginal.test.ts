import { createHash } from 'node:crypto'
import { expect, it } from 'vitest'
import runs from './paperRuns.json'
import { prose, texts } from './text.ts'

/** How many words in a row may be no more than chance. */
const LENGTH = 8

/*
 * The paper is cited and told in other words. paperRuns.json holds what is needed to see to that without holding the
 * paper: of every eight words of it in a row, in small letters and with a space between, the first twelve hexadecimal
 * digits of their SHA-256.
 */
it.each(texts)('$name has no eight words in a row from the paper', ({ markdown }) => {
  const copied = new Set(runs)
  const words =
    prose(markdown)
      .toLowerCase()
      .match(/[\p{L}\d]+/gu) ?? []
  const found = words
    .map((_, i) => words.slice(i, i + LENGTH).join(' '))
    .filter((run) => copied.has(createHash('sha256').update(run).digest('hex').slice(0, 12)))
  expect(found).toEqual([])
})
