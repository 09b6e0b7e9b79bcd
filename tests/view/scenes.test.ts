import { readdirSync, readFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { describe, expect, test } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { Scene } from '../../src/physics/index.ts'
import { openingOf } from '../../src/lab/state/opening.ts'
import { viewOf } from '../../src/view/scenes.ts'

describe.each<Scene>(scenes)('$id', (scene) => {
  const { parameters } = openingOf(scene.id as Parameters<typeof openingOf>[0])
  const view = viewOf(scene)

  test('its icon is a path within 32 by 20, and its shortest part is a length', () => {
    expect(view.icon).toMatch(/^M[\d.\sa-zA-Z-]+$/)
    expect(view.least(parameters)).toBeGreaterThan(0)
  })

  test('its track bends where its view says so, and nowhere else', () => {
    const curvature = (s: number) => scene.place(parameters, s).curvature
    const bend = view.bend?.(parameters)
    const { from, to } = bend ?? { from: 0, to: 1 }
    for (const part of [0.01, 0.5, 0.99])
      expect(curvature(from + part * (to - from))).toBeCloseTo(bend ? 1 / bend.radius : 0, 9)
    if (bend && !bend.joined) return
    for (const beyond of [from - 0.01, to + 0.01]) expect(curvature(beyond)).toBe(0)
  })
})

test('only one file of the view knows which scenes there are', () => {
  const folder = resolve(import.meta.dirname, '../../src/view')
  const ids = scenes.map(({ id }) => `'${id}'`)
  const knowing = readdirSync(folder).filter((name) => {
    const text = readFileSync(join(folder, name), 'utf8')
    return /\bscene\.id\b/.test(text) || ids.some((id) => text.includes(id))
  })
  expect(knowing.filter((name) => name !== 'scenes.ts')).toEqual([])
})
