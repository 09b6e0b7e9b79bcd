import { expect, test } from 'vitest'
import type { Spread } from '../../../src/measure/index.ts'
import { lengthText } from '../../../src/chart/numbers.ts'
import { sizeText } from '../../../src/chart/magnitudes.ts'
import { spreadText } from '../../../src/lab/state/spreadText.ts'

const plain = (text: string) => text.replaceAll('\u202f', ' ')
const spread = (values: Partial<Spread>): Spread => ({
  ...{
    outcomes: ['moving'],
    agree: true,
    abandoned: false,
    distance: 0,
    earliest: NaN,
    latest: NaN,
    scale: 1,
  },
  ...values,
})
const left = { outcomes: ['left-the-track'] } as const

test.each<[Partial<Spread>, string, string, boolean]>([
  [{ distance: 0.2251 }, '0.23 m', '', false],
  [{ distance: 3e-15 }, '0', 'to rounding', true],
  [{ distance: 3e-11 }, '3 × 10⁻⁵ µm', '', false],
  // Rounding is relative to the path.
  [{ distance: 3e-11, scale: 5 }, '0', 'to rounding', true],
  [
    { ...left, earliest: 0.3933, latest: 0.4552 },
    '61.9 ms',
    'left the track at 0.39 to 0.46 s',
    false,
  ],
  [{ ...left, earliest: 0.8269, latest: 0.827 }, '100 µs', 'left the track at 0.83 s', false],
  [{ ...left, earliest: 0.8269, latest: 0.8269 }, '0', 'left the track at 0.83 s', true],
  // One block leaves with a step that ends beyond the lip.
  [
    { ...left, earliest: 0.8, latest: 0.8, distance: 0.1 },
    '0.10 m',
    'left the track at 0.80 s',
    false,
  ],
  [{ outcomes: ['diverged'], distance: 1e9 }, 'without bound', 'all diverged', false],
  [
    { outcomes: ['moving', 'left-the-track'], agree: false, earliest: 0.8, latest: 0.8 },
    'different outcomes',
    'moving, left the track',
    false,
  ],
  // Two runs that end at one place are not the same where one of them has left the track.
  [
    { outcomes: ['left-the-track', 'diverged', 'at-rest'], agree: false },
    'different outcomes',
    'left the track, diverged, at rest',
    false,
  ],
])('%o is “%s”', (values, value, remark, exact) => {
  const text = spreadText(spread(values), lengthText)
  expect(plain(text.value)).toBe(value)
  expect(plain(text.remark)).toBe(remark)
  expect(text.exact).toBe(exact)
})

test('the table writes nanometres, and the title every digit', () => {
  const { value, title } = spreadText(spread({ distance: 4.562e-8 }), sizeText)
  expect(plain(value)).toBe('45.6 nm')
  expect(title).toBe('Largest − smallest final position: 4.562e-8 m')
})
