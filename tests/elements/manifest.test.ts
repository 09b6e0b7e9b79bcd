import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { format } from 'prettier'
import { expect, test } from 'vitest'
import { makeManifest, root } from './manifest.ts'

const path = join(root, 'custom-elements.json')

test('the manifest says what stands above the elements’ classes', async () => {
  const text = await format(JSON.stringify(makeManifest()), { parser: 'json', printWidth: 100 })
  if (process.env.MANIFEST === 'renew') writeFileSync(path, text)
  // If this fails: MANIFEST=renew npx vitest run --project unit tests/elements
  expect(readFileSync(path, 'utf8')).toBe(text)
})

test('everything in it has a name and words, once', () => {
  for (const declaration of makeManifest().modules[0]!.declarations) {
    const { attributes, members, events, slots, cssParts, cssProperties } = declaration
    for (const list of [attributes, members, events, slots, cssParts, cssProperties]) {
      const names = list.map(({ name }) => name)
      expect(new Set(names).size, names.join()).toBe(names.length)
      expect(list.filter(({ description }) => !description)).toEqual([])
      if (list !== slots) expect(names).not.toContain('')
    }
    for (const each of [...attributes, ...members, ...events])
      expect(each.type, each.name).toBeDefined()
  }
})

test('the package has it, and says so', () => {
  const { customElements, files } = JSON.parse(
    readFileSync(join(root, 'package.json'), 'utf8'),
  ) as { customElements: string; files: string[] }
  expect(customElements).toBe('custom-elements.json')
  expect(files).toContain('custom-elements.json')
})
