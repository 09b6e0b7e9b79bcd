import { expect, test } from 'vitest'
import { simulate } from '../../../src/physics/index.ts'
import { presentationErrors } from '../../../src/measure/index.ts'
import { experimentOf } from '../../../src/lab/state/check.ts'
import { lengthText } from '../../../src/chart/numbers.ts'
import { describe as inWords } from '../../../src/lab/words.ts'
import { errorText } from '../../../src/panels/runners/results.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { errorAt, Simulation } from '../../../src/lab/state/simulation.ts'
import { changed } from '../../../src/lab/state/change.ts'

test('what is simulated is what simulate returns', () => {
  const { runners, spread } = new Simulation().run(opening)
  expect(runners.map(({ trajectory }) => trajectory)).toEqual(
    opening.runners.map((runner) => simulate(experimentOf(opening, runner))),
  )
  const ends = runners.map(({ trajectory }) => trajectory.drawnS.at(-1)!)
  expect(spread!.distance).toBe(Math.max(...ends) - Math.min(...ends))
})

test('only what changed is run again', () => {
  const simulation = new Simulation()
  const before = simulation.run(opening).runners
  const values = { integrator: 'rk4' } as const
  const after = simulation.run(changed(opening, { kind: 'runner', index: 1, values })).runners
  expect(after[0]!.trajectory).toBe(before[0]!.trajectory)
  expect(after[1]!.trajectory).not.toBe(before[1]!.trajectory)
  expect(after[2]!.trajectory).toBe(before[2]!.trajectory)
})

test('a hidden runner does not count', () => {
  const hide = (index: number) => ({ kind: 'runner', index, values: { hidden: true } }) as const
  let state = changed(opening, hide(0))
  const { visible, spread } = new Simulation().run(state)
  expect(visible).toHaveLength(2)
  expect(spread!.distance).toBeLessThan(0.1)
  state = changed(changed(state, hide(1)), hide(2))
  expect(new Simulation().run(state).spread).toBeUndefined()
})

test('errors are drawnS − exact(time), as measured', () => {
  const simulated = new Simulation().run(opening)
  for (const { trajectory } of simulated.runners) {
    const { each } = presentationErrors(trajectory)
    for (let row = 0; row <= trajectory.frames; row++)
      expect(errorAt(trajectory, simulated.exact, row)).toBe(each[row])
  }
})

test('an error is signed as in the picture, and to the millimetre where that says something', () => {
  const simulated = new Simulation().run(opening)
  const texts = simulated.runners.map(
    ({ trajectory }) => errorText(simulated, trajectory, trajectory.frames).text,
  )
  expect(texts).toEqual(['−0.246\u202fm', '−0.082\u202fm', '−0.021\u202fm'])
  const located = new Simulation().run(changed(opening, { kind: 'mode', mode: 'located' }))
  const { trajectory } = located.runners[0]!
  const { text, title } = errorText(located, trajectory, trajectory.frames)
  expect(text).toMatch(/^0/)
  expect(title).toContain('s − exact(t) = ')
  const fall = new Simulation().run(changed(opening, { kind: 'scene', scene: 'fall' }))
  expect(errorText(fall, fall.runners[0]!.trajectory, 20).text).toMatch(/^\+0\.5\d\d\u202fm$/)
})

test.each([
  [0.2251, '0.23\u202fm'],
  [0.5, '0.50\u202fm'],
  [0.00123, '1.2\u202fmm'],
  [0, '0 (to rounding)'],
  [Infinity, 'without bound'],
  [NaN, 'without bound'],
])('a spread of %d m', (spread, text) => expect(lengthText(spread)).toBe(text))

test('the picture in words', () => {
  const simulated = new Simulation().run(opening)
  const words = inWords(simulated, 1)
  expect(words).toContain('10 fps: stopped at 1.47\u202fm, 0.25\u202fm short of the exact block.')
  expect(inWords(simulated, 0.5)).toContain('10 fps: at 1.41\u202fm, 0.18\u202fm short of')
  const located = new Simulation().run(changed(opening, { kind: 'mode', mode: 'located' }))
  expect(inWords(located, 1)).toContain('10 fps: stopped at 1.72\u202fm, on the exact block.')
})

test('a runner that leaves the track, and one that blows up, is said to', () => {
  let state = changed(opening, { kind: 'scene', scene: 'half-pipe' })
  state = changed(state, { kind: 'runner', index: 0, values: { integrator: 'explicit-euler' } })
  expect(inWords(new Simulation().run(state), 6)).toMatch(/left the track after \d/)
  state = changed(opening, { kind: 'scene', scene: 'spring' })
  state = changed(state, { kind: 'parameters', values: { stiffness: 4000 } })
  const words = inWords(new Simulation().run(state), 4)
  expect(words).toMatch(/10 fps: blew up after \d/)
})
