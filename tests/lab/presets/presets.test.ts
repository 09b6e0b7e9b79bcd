import { describe, expect, test } from 'vitest'
import { hardCases } from '../../../src/measure/hardCases/index.ts'
import { parseExperiment, simulate } from '../../../src/physics/index.ts'
import { clockOf } from '../../../src/physics/frames/index.ts'
import type { Experiment } from '../../../src/physics/index.ts'
import { readAddress, writeAddress } from '../../../src/lab/state/address.ts'
import { experimentOf } from '../../../src/lab/state/check.ts'
import { modes } from '../../../src/lab/state/modes.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { presets } from '../../../src/lab/presets/index.ts'
import { MOST_FRAMES, stateOf, sideBySide } from '../../../src/lab/presets/hardCases.ts'
import { changed } from '../../../src/lab/state/change.ts'
import { count } from '../../../src/chart/numbers.ts'
import { endOf } from '../../../src/view/timeline.ts'

const refused = hardCases.filter((hardCase) => hardCase.refused).map(({ label }) => label)
const runnable = presets.filter(({ label }) => !refused.includes(label))
const experimentsOf = (preset: (typeof presets)[number]) =>
  preset.shown.state.runners.map((runner) => experimentOf(preset.shown.state, runner))
/** All but the duration, which may be cut. */
const key = (experiment: Experiment) =>
  JSON.stringify({ ...parseExperiment(experiment), duration: undefined })

test('every preset is a lab that can be run, has a name of its own and says what to watch', () => {
  for (const { label, watch, shown } of runnable) {
    expect(shown.problem, label).toBe('')
    expect(watch, label).toMatch(/^\S.{20,}\.$/)
  }
  expect(new Set(presets.map(({ label }) => label)).size).toBe(presets.length)
  // No ids.
  for (const { label, group } of presets)
    expect(`${group} ${label}`).not.toMatch(/\w-\w+-\w|[A-Z]{2}\w/)
})

test('the same state every time', () => {
  for (const { shown } of presets.slice(0, 8)) expect(shown.state).toBe(shown.state)
})

test('each fits into an address', () => {
  for (const { label, shown } of runnable)
    expect(readAddress(writeAddress(shown.state)), label).toEqual(shown.state)
})

test('the opening and each of its modes are among them', () => {
  const states = presets.map(({ shown }) => shown.state)
  expect(states[0]).toBe(opening)
  for (const { id } of modes)
    expect(states).toContainEqual(changed(opening, { kind: 'mode', mode: id }))
})

describe('the hard cases', () => {
  const shown = new Set(runnable.flatMap(experimentsOf).map(key))

  test('are all there, with all of their experiments', () => {
    const numbers = new Set(hardCases.map(({ group }) => group))
    expect([...numbers].sort((a, b) => a - b)).toEqual(Array.from({ length: 28 }, (_, i) => i + 1))
    for (const { label, watch, experiments } of hardCases) {
      expect(
        presets.some((each) => each.label.startsWith(label) && each.watch.startsWith(watch)),
      ).toBe(true)
      if (!refused.includes(label))
        for (const experiment of experiments) expect(shown.has(key(experiment)), label).toBe(true)
    }
  })

  test('that are refused show why, and a lab all the same', () => {
    expect(refused.length).toBeGreaterThan(0)
    for (const label of refused) {
      const { shown } = presets.find((each) => each.label === label)!
      expect(shown.problem).toMatch(
        new RegExp(
          `^“${label}” can’t be run here. The lab shows its opening instead.\nparameters\\.`,
        ),
      )
      expect(shown.state).toBe(opening)
    }
  })
})

test('none is longer than a page can bear', () => {
  for (const { label, shown } of runnable) {
    const { duration, runners } = shown.state
    const frames = runners.map(({ frames }) => clockOf(frames).frames(duration))
    expect(
      frames.reduce((a, b) => a + b),
      label,
    ).toBeLessThanOrEqual(MOST_FRAMES)
  }
})

test('a run that is too long is cut to its beginning, others are left as they are', () => {
  const long: Experiment = { scene: 'ramp', duration: 10000 }
  expect(stateOf([long, long]).duration).toBe(2000)
  expect(stateOf([{ ...long, duration: 1234.5 }]).duration).toBe(1234.5)
})

test('without delta time only the fast one is at rest after a second', () => {
  const preset = presets.find(({ label }) => label === 'Without delta time')!
  expect(preset.watch).toContain('After a second only the fast one is at rest.')
  expect(preset.shown.state.duration).toBe(1)
  const rests = experimentsOf(preset).map((each) => endOf(simulate(each))?.kind === 'at-rest')
  expect(rests).toEqual([false, false, true])
})

test('what is cut says so', () => {
  const cut = presets.filter(({ watch }) => watch.includes('are shown here'))
  expect(cut.map(({ label }) => label)).toContain('A pipe, from a degree below its lip')
  for (const { watch, shown } of cut)
    expect(watch).toContain(`the first ${count(shown.state.duration)} s are shown here.`)
})

test('experiments are together that share scene, parameters and duration', () => {
  const ramp: Experiment = { scene: 'ramp', duration: 1 }
  const steep: Experiment = { ...ramp, parameters: { angle: 50 } }
  const slow: Experiment = { ...ramp, frames: { kind: 'steady', fps: 5 } }
  expect(sideBySide([ramp, steep, slow])).toEqual([[ramp, slow], [steep]])
})
