import { expect, test } from 'vitest'
import { namesOf } from '../../src/figure/names.ts'
import { opening } from '../../src/figure/opening.ts'
import { changed } from '../../src/figure/state.ts'
import type { RunnerState } from '../../src/figure/state.ts'

const [ten] = opening.runners as [RunnerState]

test.each([
  ['frame rates', opening.runners, ['10 fps', '30 fps', '120 fps']],
  ['one', [ten], ['10 fps']],
  ['integrators', [ten, { ...ten, integrator: 'rk4' }], ['Semi-implicit Euler', 'Runge–Kutta 4']],
  [
    'frames and stops',
    [ten, { ...ten, stopping: 'located' }, { ...ten, frames: { kind: 'steady', fps: 20 } }],
    ['10 fps · Clamped', '10 fps · Located', '20 fps · Clamped'],
  ],
  ['nothing', [ten, ten], ['10 fps', '10 fps']],
  [
    'clocks',
    [ten, { ...ten, frames: { kind: 'jitter', fps: 10, amount: 1, seed: 1 } }],
    ['10 fps', '10 fps, jitter'],
  ],
] as const)('runners that differ in %s', (_, runners, names) => {
  expect(namesOf(runners as readonly RunnerState[])).toEqual(names)
})

test('a name follows the state', () => {
  const state = changed(opening, {
    kind: 'option',
    index: 0,
    of: 'frames',
    key: 'fps',
    value: 12.5,
  })
  expect(namesOf(state.runners)[0]).toBe('12.5 fps')
})
