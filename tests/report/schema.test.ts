import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { reportProblems } from '../../src/report/schema/index.ts'
import type { Report } from '../../src/report/schema/index.ts'

const text = readFileSync(join(import.meta.dirname, '../../public/report/report.json'), 'utf8')
const report = () => JSON.parse(text) as Report

test('the report that is published has its shape, and was measured with care', () => {
  expect(reportProblems(report())).toEqual([])
  expect(report().machine.quick).toBe(false)
})

test('what is wrong is named with its place', () => {
  const wrong = report()
  wrong.engineTests.runs[3]!.error = -1
  wrong.targets[0]!.sense = 'about' as 'at most'
  Object.assign(wrong.machine, { cores: '2', coolers: 1 })
  Object.assign(wrong, { frames: {}, notRun: undefined })
  expect(reportProblems(wrong)).toEqual([
    'report.machine.cores: "2" is not a number of 0 or more',
    'report.machine.coolers: is not known',
    'report.frames: {} is not a list',
    'report.engineTests.runs[3].error: -1 is not a number of 0 or more',
    'report.targets[0].sense: "about" is not one of at most, at least',
    'report.notRun: nothing is not a list',
  ])
})

test.each([undefined, null, [], 'report', 1])('%j is not a report', (value) => {
  expect(reportProblems(value)).toHaveLength(1)
})

test('every figure belongs to somebody who is introduced', () => {
  const { engines, engineTests, frontiers } = report()
  const ids = engines.map(({ id }) => id)
  for (const { engine } of [...engineTests.runs, ...engineTests.times, ...engineTests.friction])
    expect(ids).toContain(engine)
  for (const run of engineTests.runs) {
    expect(engineTests.scenes.map(({ id }) => id)).toContain(run.scene)
    expect(engineTests.clocks).toContain(run.clock)
  }
  for (const { curves } of frontiers) expect(curves.map(({ id }) => id)).toContain('odex')
})
