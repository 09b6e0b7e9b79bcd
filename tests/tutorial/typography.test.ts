import { expect, it } from 'vitest'
import { prose, texts } from './text.ts'

it('apostrophes and quotation marks are typographic, and minus signs are not hyphens', () => {
  for (const { name, markdown } of texts) {
    expect(prose(markdown).match(/.{0,12}["'].{0,12}/g) ?? [], name).toEqual([])
    expect(prose(markdown).match(/.{0,12}[^\p{L}\d]-\d.{0,12}/gu) ?? [], name).toEqual([])
  }
})
