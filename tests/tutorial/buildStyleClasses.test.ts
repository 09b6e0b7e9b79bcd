import { expect, test } from 'vitest'
import { styleClasses } from '../../src/tutorial/build/plugin.ts'

test('style attributes become classes, alike ones the same, beside those that are there', () => {
  const { html, css } = styleClasses(
    '<p style="color: red">a</p><br/><text x="1" style="color: red" class="b c">style="d"</text><i class="e" style="top:0"/>',
  )
  expect(html).toBe(
    '<p class="style-0">a</p><br/><text x="1" class="style-0 b c">style="d"</text><i class="style-1 e"/>',
  )
  expect(css).toBe('.style-0 { color: red }\n.style-1 { top:0 }\n')
})
