import { expect, test } from 'vitest'
import { aboutOf, modes } from '../../../src/lab/state/modes.ts'
import { openingOf } from '../../../src/lab/state/opening.ts'
import { scenes } from '../../../src/physics/index.ts'

const tellsOfFriction = /trembles|at rest|at which the block stops/
const spoken = (parameters: Readonly<Record<string, number>>) =>
  modes.map((mode) => aboutOf(mode, { parameters })).join(' ')

test.each(scenes)('of friction the modes only speak where there is some: $id', ({ id }) => {
  const { parameters } = openingOf(id)
  const { muStatic = 0, muKinetic = 0 } = parameters
  if (muStatic + muKinetic > 0) expect(spoken(parameters)).toMatch(tellsOfFriction)
  else expect(spoken(parameters)).not.toMatch(tellsOfFriction)
  expect(spoken({ ...parameters, muStatic: 0, muKinetic: 0 })).not.toMatch(tellsOfFriction)
  expect(spoken({ ...parameters, muStatic: 0.1, muKinetic: 0 })).toMatch(tellsOfFriction)
})
