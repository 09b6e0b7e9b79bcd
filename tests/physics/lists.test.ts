import { expect, it } from 'vitest'
import { entry } from '../../src/physics/lists.ts'

it('an entry that a list does not have is an error that names those it has', () => {
  expect(() => entry([{ id: 'fall' }, { id: 'ramp' }], 'loop')).toThrow(
    'There is no “loop” in the list fall, ramp.',
  )
})
