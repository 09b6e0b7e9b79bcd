import { expect, test } from 'vitest'
import { namesOf } from '../../../src/lab/state/names.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import { changed } from '../../../src/lab/state/change.ts'
import type { RunnerState } from '../../../src/lab/state/state.ts'

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
  [
    'a number of their timestep',
    [
      { ...ten, timestep: { kind: 'capped', cap: 0.05 } },
      { ...ten, timestep: { kind: 'capped', cap: 0.1 } },
    ],
    ['cap 0.05 s', 'cap 0.1 s'],
  ],
  [
    'a number that one of them has not',
    [
      { ...ten, timestep: { kind: 'capped', cap: 0.05 } },
      { ...ten, timestep: { kind: 'capped', cap: 0.1 } },
      ten,
    ],
    ['Capped · cap 0.05 s', 'Capped · cap 0.1 s', 'Variable'],
  ],
  [
    'a number of their frames',
    [
      { ...ten, frames: { kind: 'jitter', fps: 10, amount: 1, seed: 1 } },
      { ...ten, frames: { kind: 'jitter', fps: 10, amount: 1, seed: 2 } },
    ],
    ['seed 1', 'seed 2'],
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
