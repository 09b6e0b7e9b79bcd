import { expect, test } from 'vitest'
import { aboutOf, modes } from '../../src/figure/modes.ts'
import { scenes } from '../../src/physics/index.ts'

test.each(scenes)('of friction the modes only speak where $id has it', (scene) => {
  const spoken = modes.map((mode) => aboutOf(mode, scene)).join(' ')
  const rubs = /trembles|at rest|at which the block stops/
  if (scene.id === 'fall') expect(spoken).not.toMatch(rubs)
  else expect(spoken).toMatch(rubs)
})
