import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, it } from 'vitest'
import { drawDiagrams } from '../../src/report/diagrams/index.ts'
import { engineClocks, engineScenes } from '../../src/report/engines/scenes.ts'
import { runOurs } from '../../src/report/engines/run.ts'
import { ours } from '../../src/report/engines/index.ts'
import type { Report } from '../../src/report/schema/index.ts'
import { targets } from '../../src/report/targets.ts'
import { withReport } from '../../src/report/text/readme.ts'
import { rounded } from '../../src/report/text/rounded.ts'

const root = join(import.meta.dirname, '../..')
const folder = join(root, 'public/report')
const report = JSON.parse(readFileSync(join(folder, 'report.json'), 'utf8')) as Report
const readme = readFileSync(join(root, 'README.md'), 'utf8')

describe('what is published follows from the figures, and nothing of it is typed', () => {
  it('the tables in README', async () => {
    expect(await withReport(readme, report)).toBe(readme)
    expect(await withReport(readme.replaceAll('10 fps', '11 fps'), report)).toBe(readme)
  })

  it('the diagrams', () => {
    const drawn = drawDiagrams(report)
    expect(drawn.map(({ about }) => about)).toEqual(report.diagrams)
    for (const { about, svg } of drawn)
      expect(readFileSync(join(folder, about.file), 'utf8'), about.file).toBe(svg)
    expect(readdirSync(folder).sort()).toEqual(
      ['report.json', ...drawn.map(({ about }) => about.file)].sort(),
    )
  })

  it('the targets: met or missed as their figures say', () => {
    expect(rounded(targets(report))).toEqual(report.targets)
  })

  it('our own runs, which are the same on every machine', () => {
    for (const { id, method } of ours)
      for (const scene of engineScenes)
        for (const { label: clock, frames } of engineClocks) {
          const published = report.engineTests.runs.find(
            (run) => run.engine === id && run.scene === scene.id && run.clock === clock,
          )
          const run = { engine: id, scene: scene.id, clock, ...runOurs(method, scene, frames) }
          expect(published).toEqual(rounded(run))
        }
  })
})

describe('README', () => {
  it('names each part of the report once, with its end', () => {
    const names = [...readme.matchAll(/<!-- report:([\w-]+) -->/g)].map(([, name]) => name)
    expect(names.length).toBeGreaterThan(8)
    expect(new Set(names).size).toBe(names.length)
    expect([...readme.matchAll(/<!-- \/report:([\w-]+) -->/g)].map(([, name]) => name)).toEqual(
      names,
    )
  })

  it.each([
    '<!-- report:nobody -->\n<!-- /report:nobody -->',
    '<!-- report:frames -->\n<!-- /report:targets -->',
  ])('a marker that leads nowhere is refused: %s', async (markers) => {
    await expect(withReport(markers, report)).rejects.toThrow('README: report:')
  })
})

it('a diagram is a picture with a name and words, light and dark, and has no number that is none', () => {
  for (const { about, svg } of drawDiagrams(report)) {
    expect(existsSync(join(folder, about.file))).toBe(true)
    expect(svg).toContain(`<title id="${about.file.replace('.svg', '')}-title">`)
    expect(svg).toContain('role="img"')
    expect(svg).toContain('prefers-color-scheme: dark')
    expect(svg).not.toMatch(/NaN|Infinity|undefined/)
    expect(about.description).not.toMatch(/NaN|Infinity|undefined/)
  }
})
