import { expect, it } from 'vitest'
import { engineChoices } from '../../../src/lab/presets/engines.ts'
import { preset } from '../../../src/lab/presets/preset.ts'
import { checked } from '../../../src/lab/state/check.ts'
import { opening } from '../../../src/lab/state/opening.ts'
import type { LabState } from '../../../src/lab/state/state.ts'

const DURATIONS = [1, 100, 10_000, 50_000, 100_000]

it('an engine that can’t run what is in the lab leaves it as it is, and says why', () => {
  let refused = 0
  for (const duration of DURATIONS)
    for (const { label, presetOf } of engineChoices) {
      // Ten frames a second, so that the lab itself can run it.
      const runners = opening.runners
        .slice(0, 2)
        .map((runner) => ({ ...runner, frames: { kind: 'steady', fps: 9 } }) as const)
      const state: LabState = checked({ ...opening, duration, runners })
      const { shown } = presetOf(state, 0)
      if (shown.problem) {
        refused++
        expect(shown.state, label).toBe(state)
        expect(shown.problem).toMatch(
          new RegExp(`^“${label}” can’t be run here. The lab stays as it is.\n.* asks for `),
        )
      } else expect(shown.state.duration).toBe(duration)
    }
  expect(refused).toBeGreaterThan(0)
  expect(refused).toBeLessThan(DURATIONS.length * engineChoices.length)
})

it('a preset of nobody’s lab that can’t be run shows the opening', () => {
  const { state, problem } = preset('', 'Steep', '', () =>
    checked({ ...opening, parameters: { ...opening.parameters, angle: 95 } }),
  ).shown
  expect(state).toBe(opening)
  expect(problem).toMatch(/^“Steep” can’t be run here. The lab shows its opening instead.\n.*angle/)
})
