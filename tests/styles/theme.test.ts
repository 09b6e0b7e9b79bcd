import { readFileSync } from 'node:fs'
import { resolve } from 'node:path'
import { expect, test } from 'vitest'

const css = readFileSync(resolve(import.meta.dirname, '../../src/styles/theme.css'), 'utf8')
const [light, dark, system] = [
  ':root {',
  "[data-theme='dark'] {",
  ":root:not([data-theme='light'])",
]
  .map((selector) => css.slice(css.indexOf(selector)).split('}')[0]!)
  .map((block): Record<string, string> =>
    Object.fromEntries(
      [...block.matchAll(/--([\w-]+): (#\w{6});/g)].map((found) => [found[1]!, found[2]!]),
    ),
  )

test('dark by the switch is dark by the system', () => {
  expect(dark).toEqual(system)
  expect(Object.keys(dark!)).toEqual(Object.keys(light!))
})

test.each([
  ['light', light!],
  ['dark', dark!],
])('contrast in the %s theme', (_, colours) => {
  for (const behind of ['paper', 'sheet', 'ground']) {
    for (const text of ['ink', 'ink-soft', 'accent', 'wrong'])
      expect(contrast(colours[text]!, colours[behind]!), `${text} on ${behind}`).toBeGreaterThan(
        4.5,
      )
    for (let i = 0; i < 8; i++)
      expect(
        contrast(colours[`runner-${i}`]!, colours[behind]!),
        `${i} on ${behind}`,
      ).toBeGreaterThan(3)
  }
  expect(contrast(colours['on-accent']!, colours.accent!)).toBeGreaterThan(4.5)
})

/** As WCAG defines it. */
function contrast(a: string, b: string): number {
  const [low, high] = [luminance(a), luminance(b)].sort((p, q) => p - q) as [number, number]
  return (high + 0.05) / (low + 0.05)
}

function luminance(colour: string): number {
  const [r, g, b] = [1, 3, 5]
    .map((i) => parseInt(colour.slice(i, i + 2), 16) / 255)
    .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
  return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!
}
