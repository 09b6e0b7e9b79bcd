import { readFileSync } from 'node:fs'
import { resolve } from 'node:path'
import { expect, it } from 'vitest'
import { prose, texts } from './text.ts'

/*
 * words.txt holds every word of the text, in British spelling, each checked once against a dictionary and read in its
 * place. A word that is not in it is either new or misspelt: look at it, then add its line. So a later typo is seen,
 * unless it makes another word that the text has.
 */
const path = resolve(import.meta.dirname, 'words.txt')
const known = readFileSync(path, 'utf8').trimEnd().split('\n')

const wordsOf = (markdown: string) => prose(markdown).match(/\p{L}+(?:[’'‘]\p{L}+)*/gu) ?? []

it.each(texts)('$name has no word that is not in words.txt', ({ markdown }) => {
  const listed = new Set(known)
  const strange = wordsOf(markdown).filter(
    (word) => !listed.has(word) && !listed.has(word.toLowerCase()),
  )
  expect(strange).toEqual([])
})

it('the list is sorted, without doubles, and has no word that the text has not', () => {
  expect(known).toEqual([...new Set(known)].sort())
  const used = new Set(texts.flatMap(({ markdown }) => wordsOf(markdown)))
  const lower = new Set([...used].map((word) => word.toLowerCase()))
  expect(known.filter((word) => !used.has(word) && !lower.has(word))).toEqual([])
})

it('the spelling is British', () => {
  const american =
    /^(?:colors?|colored|center|centered|meters?|behavior|favor\w*|neighbor\w*|gray|fiber|traveled|modeled|labeled|canceled|defense|\w+(?:ize|ized|izes|izing|ization|yze|yzed))$/i
  const doubtful = known.filter((word) => american.test(word) && !/^sizes?$/.test(word))
  expect(doubtful).toEqual([])
})

it('apostrophes and quotation marks are typographic, and minus signs are not hyphens', () => {
  for (const { name, markdown } of texts) {
    expect(prose(markdown).match(/.{0,12}["'].{0,12}/g) ?? [], name).toEqual([])
    expect(prose(markdown).match(/.{0,12}[^\p{L}\d]-\d.{0,12}/gu) ?? [], name).toEqual([])
  }
})
