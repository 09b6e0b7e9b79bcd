import { expect, it } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import { entry } from '../../src/physics/lists.ts'

it('an entry that a list does not have is an error that names those it has', () => {
  expect(() => entry(scenes, 'loop')).toThrow(
    'There is no “loop” in the list fall, ramp, run-out, half-pipe, spring.',
  )
})
