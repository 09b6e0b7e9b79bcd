import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, relative } from 'node:path'
import { describe, expect, it } from 'vitest'
import { drawDiagrams } from '../../src/report/diagrams/index.ts'
import { engineClocks, engineScenes } from '../../src/report/engines/scenes.ts'
import { controlled } from '../../src/report/frontiers/controlled.ts'
import { runOurs } from '../../src/report/engines/run.ts'
import { ours } from '../../src/report/engines/index.ts'
import type { Report } from '../../src/report/schema/index.ts'
import { targets } from '../../src/report/targets.ts'
import { benchmarksFile, benchmarksPage } from '../../src/report/text/benchmarks.ts'
import { rounded, writeReport } from '../../src/report/write.ts'

const root = join(import.meta.dirname, '../..')
const folder = join(root, 'public/report')
const report = JSON.parse(readFileSync(join(folder, 'report.json'), 'utf8')) as Report

describe('what is published follows from the figures, and nothing of it is typed', () => {
  it('the page of benchmarks', async () => {
    expect(await benchmarksPage(report)).toBe(readFileSync(join(root, benchmarksFile), 'utf8'))
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

  it('evaluations to tolerance and of odex, which are the same on every machine', () => {
    expect(rounded(controlled())).toEqual(report.controlled)
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

it('the page of benchmarks shows every diagram once, and says what did not run', async () => {
  const page = await benchmarksPage({ ...report, notRun: [{ what: 'planck', why: 'missing' }] })
  const shown = [...page.matchAll(/\]\(\.\.\/public\/report\/([^)]+)\)/g)].map(([, file]) => file!)
  expect(shown.sort()).toEqual(report.diagrams.map(({ file }) => file).sort())
  expect(page).toContain('- **planck**: missing')
  expect(page).not.toContain('Everything ran.')
})

it('a report writes its numbers, its diagrams and its page, and nothing else', async () => {
  const written = mkdtempSync(join(tmpdir(), 'report-'))
  await writeReport(report, () => undefined, written)
  const files = readdirSync(written, { recursive: true, encoding: 'utf8', withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => relative(written, join(parentPath, name)))
  expect(files).toHaveLength(report.diagrams.length + 2)
  for (const file of files)
    expect(readFileSync(join(written, file), 'utf8'), file).toBe(
      readFileSync(join(root, file), 'utf8'),
    )
  rmSync(written, { recursive: true })
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
