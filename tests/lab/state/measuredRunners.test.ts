/** A lab whose runners measure their frames wrongly, or that goes in slow motion. */
import { expect, test } from 'vitest'
import type { Experiment } from '../../../src/physics/index.ts'
import { readAddress, writeAddress } from '../../../src/lab/state/address.ts'
import { changed } from '../../../src/lab/state/change.ts'
import { choose } from '../../../src/lab/state/choose.ts'
import { clockworkOf, onTheWall, stepTimes } from '../../../src/lab/state/clockwork.ts'
import { namesOf } from '../../../src/lab/state/names.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { errorAt, Simulation } from '../../../src/lab/state/simulation.ts'
import { experimentsIn, labOf } from '../../../src/lab/state/together.ts'
import { toJson } from '../../../src/panels/share/texts.ts'
import { noteOf } from '../../../src/panels/strip/stripWords.ts'

test.each([
  'steady(fps:60,delta:rounded)',
  'steady(fps:60,delta:late)',
  'jitter(fps:60,amount:0.5,seed:1,delta:mean)',
  'missed-vsync(fps:60,seed:1,delta:mean,meanOf:5)',
  'recorded(durations:1/300+1/150,delta:snapped,snapTo:75)',
])('%s goes through an address and through JSON', (frames) => {
  const address = `timeScale=0.1&runners=30;${frames}`
  const state = readAddress(address)
  expect(writeAddress(state)).toBe(address)
  expect(labOf(experimentsIn(toJson(state))!).runners[1]!.frames).toEqual(state.runners[1]!.frames)
  expect(labOf(experimentsIn(toJson(state))!).timeScale).toBe(0.1)
})

test('what is as it begins is not said', () => {
  const { runners } = readAddress('runners=steady(fps:60,delta:exact,meanOf:10,snapTo:60)')
  expect(runners[0]!.frames).toEqual({ kind: 'steady', fps: 60 })
  expect(writeAddress({ ...opening, timeScale: 1 })).toBe('')
})

test.each([
  ['runners=steady(fps:60,delta:wrong)', 'frames.delta'],
  ['runners=steady(fps:60,delta:mean,meanOf:2.5)', 'frames.meanOf'],
  ['runners=steady(fps:60,delta:snapped,snapTo:0)', 'frames.snapTo'],
  ['timeScale=0', 'timeScale'],
  ['timeScale=fast', 'timeScale'],
])('%s is refused at %s', (address, path) => {
  expect(() => readAddress(address)).toThrow(path)
})

test('the reader’s choices, one after the other', () => {
  const pick = (state: typeof opening, key: string, value: unknown) =>
    changed(state, { kind: 'option', index: 0, of: 'frames', key, value })
  let state = pick(opening, 'delta', 'mean')
  state = pick(state, 'meanOf', 4)
  expect(state.runners[0]!.frames).toEqual({ kind: 'steady', fps: 10, delta: 'mean', meanOf: 4 })
  // Another clock is measured by the same game.
  const jitter = choose('frames', 'jitter', state.runners[0]!.frames)
  expect(jitter).toMatchObject({ kind: 'jitter', fps: 10, delta: 'mean', meanOf: 4 })
  expect(pick(state, 'delta', 'exact').runners[0]!.frames).not.toHaveProperty('delta')
  expect(changed(opening, { kind: 'timeScale', timeScale: 0.25 }).timeScale).toBe(0.25)
  expect(() => changed(opening, { kind: 'timeScale', timeScale: 1e9 })).toThrow('0.01…100')
})

test('names say how frames are measured', () => {
  const { runners } = readAddress(
    'runners=60;steady(fps:60,delta:rounded);jitter(fps:60,amount:1,seed:1,delta:mean,meanOf:5)',
  )
  expect(namesOf(runners)).toEqual([
    '60 fps',
    '60 fps, rounded delta',
    '60 fps, jitter, mean delta 5',
  ])
})

test('runners that differ in their time scale are not one lab’s', () => {
  const runs = [{ scene: 'ramp' }, { scene: 'ramp', timeScale: 0.5 }] satisfies Experiment[]
  expect(() => labOf(runs)).toThrow('time scale')
})

test('in slow motion the exact block is slow too', () => {
  const slow = new Simulation().run({ ...opening, timeScale: 0.1 })
  const usual = new Simulation().run(opening)
  expect(slow.exact(0.8, { s: 0, v: 0 }).s).toBeCloseTo(usual.exact(0.08, { s: 0, v: 0 }).s, 12)
  const located = new Simulation().run(changed(slow.state, { kind: 'mode', mode: 'located' }))
  for (const { trajectory } of located.runners)
    for (let row = 0; row <= trajectory.frames; row++)
      expect(errorAt(trajectory, located.exact, row)).toBeCloseTo(0, 12)
})

test('steps stand on the wall clock in the frames that took them', () => {
  const state = readAddress(
    'timeScale=0.5&duration=1&runners=steady(fps:60,delta:rounded)/fixed(step:1/60);60/fixed(step:1/60)',
  )
  const [wrong, right] = new Simulation().run(state).runners.map(({ trajectory }) => trajectory)
  for (const run of [wrong!, right!]) {
    const times = [...stepTimes(run, 1, run.frames)]
    expect(times).toHaveLength(run.steps)
    for (const [i, time] of times.entries()) {
      const row = run.stateTime.findIndex((t) => t > (i + 0.5) / 60)
      expect(time).toBeGreaterThan(run.time[row - 1]! - 1e-9)
      expect(time).toBeLessThan(run.time[row]! + 1e-9)
    }
    const { accumulator } = clockworkOf(run)
    expect(Math.max(...accumulator)).toBeLessThan(1 / 60)
  }
  expect(right!.steps).toBe(30)
  expect(onTheWall(right!, 0.25)).toBeCloseTo(0.5, 12)
})

test('the strip says how far a game that measures wrongly is off', () => {
  const note = (address: string) => {
    const { runners } = new Simulation().run(readAddress(`duration=2&${address}`))
    return noteOf(runners[0]!, 2).replaceAll('\u202f', ' ')
  }
  expect(note('runners=steady(fps:60,delta:rounded)')).toMatch(/physics is 0.04 s ahead$/)
  expect(note('runners=steady(fps:30,delta:rounded)')).toMatch(/physics is 0.02 s behind$/)
  expect(note('runners=steady(fps:10,delta:late)')).toMatch(/physics is 0.10 s behind$/)
  expect(note('runners=steady(fps:60,delta:mean)')).toMatch(/physics is on time$/)
  expect(note('timeScale=0.1&runners=60')).toBe('')
  expect(note('timeScale=0.1&runners=60/per-frame(step:1/60)')).toMatch(/on time$/)
})
