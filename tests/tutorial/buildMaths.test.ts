import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, test } from 'vitest'
import { mathml } from '../../src/tutorial/build/maths.ts'
import { tutorialArticle } from '../../src/tutorial/build/load.ts'
import { markdown } from '../../src/tutorial/build/tutorial.ts'

const root = join(import.meta.dirname, '../..')

/** What the tokens of a text are, and what stands in them; maths is read before anything knows of a book. */
function tokens(text: string): [string, string][] {
  const md = markdown()
  md.core.ruler.disable(['headings', 'resolve', 'together'])
  return md
    .parse(text, {})
    .flatMap((token) => token.children ?? [token])
    .filter(({ type }) => type === 'maths' || type === 'equation' || type === 'text')
    .map(({ type, content }) => [type, content])
}

describe('maths', () => {
  test.each([
    [
      'a $x_1$ b',
      [
        ['text', 'a '],
        ['maths', 'x_1'],
        ['text', ' b'],
      ],
    ],
    [
      '$a$, $b$',
      [
        ['maths', 'a'],
        ['text', ', '],
        ['maths', 'b'],
      ],
    ],
    // Stars and underscores in it are no emphasis, and a backslash is TeX's.
    [
      '$a_b*c*d_e$ $\\vec g$',
      [
        ['maths', 'a_b*c*d_e'],
        ['text', ' '],
        ['maths', '\\vec g'],
      ],
    ],
    ['It costs $5 and $6.', [['text', 'It costs $5 and $6.']]],
    ['$$x = 1$$', [['equation', 'x = 1']]],
    [
      '$$\nx = 1\n$$\nText.',
      [
        ['equation', 'x = 1'],
        ['text', 'Text.'],
      ],
    ],
    [
      'Text:\n$$ x\n= 1$$',
      [
        ['text', 'Text:'],
        ['equation', 'x\n= 1'],
      ],
    ],
  ])('in %j', (text, expected) => {
    expect(tokens(text)).toEqual(expected)
  })

  test('is MathML, its symbols in the colours of forces', () => {
    const built = mathml('\\class{gravity}{\\vec G} = m \\vec g', true)
    expect(built).toMatch(/^<math display="block"/)
    expect(built).toMatch(/<mover class="gravity"><mi>G<\/mi>/)
    expect(mathml('x', false)).not.toContain('display=')
  })

  test('is refused where it is none, or has a class that there is not', () => {
    expect(() => mathml('\\frac{1', false)).toThrow()
    expect(() => mathml('\\foo', false)).toThrow()
    expect(mathml('\\class{friction}{x}', false)).toContain('friction')
    expect(() => mathml('\\class{frictoin}{x}', false)).toThrow()
  })
})

test('every letter of the equations is in the font', () => {
  const readme = readFileSync(join(root, 'src/fonts/README.md'), 'utf8')
  const inFont = new Set(
    [...readme.matchAll(/^maths\+?=,?(.*)$/gm)].flatMap((match) =>
      match[1]!.split(',').flatMap(range),
    ),
  )
  expect(inFont.size).toBeGreaterThan(100)
  const article = tutorialArticle(root, ['lab', 'source', 'tutorial'])
  const missing = [...article.matchAll(/<math[^]*?<\/math>/g)]
    .flatMap(([math]) => lettersOf(math))
    .filter((letter) => !inFont.has(letter.codePointAt(0)!))
  expect([...new Set(missing)]).toEqual([])
})

/** `U+0028-0039` or `U+221A`. */
function range(text: string): number[] {
  const [from, to = from] = text.replace('U+', '').split('-') as [string, string?]
  const first = parseInt(from, 16)
  return Array.from({ length: parseInt(to, 16) - first + 1 }, (_, i) => first + i)
}

/** The letters as a browser sets them: a lone one in `<mi>` in italics. */
function lettersOf(math: string): string[] {
  return [...math.matchAll(/<(\w+)([^>]*)>([^<]+)/g)].flatMap(([, tag, attributes, text]) => {
    const letters = [...text!.replace(/&amp;/g, '&').replace(/&lt;/g, '<').replace(/&gt;/g, '>')]
    const upright = tag !== 'mi' || letters.length > 1 || attributes!.includes('normal')
    return upright ? letters : letters.map(italic)
  })
}

function italic(letter: string): string {
  if (letter === 'h') return '\u210e'
  const offsets: [string, string, number][] = [
    ['A', 'Z', 0x1d434],
    ['a', 'z', 0x1d44e],
    ['α', 'ω', 0x1d6fc],
  ]
  for (const [from, to, start] of offsets)
    if (letter >= from && letter <= to)
      return String.fromCodePoint(start + letter.codePointAt(0)! - from.codePointAt(0)!)
  return letter
}
