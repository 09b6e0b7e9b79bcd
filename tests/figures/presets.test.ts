import { expect, test } from 'vitest'
import { initialValues } from '../../src/figures/shared/control.ts'
import { figures } from '../../src/figures/index.ts'
import { figurePresets } from '../../src/lab/presets/figures.ts'
import { stateOf, sideBySide } from '../../src/lab/presets/hardCases.ts'

/** What a lab can't show: another step, the work of a whole sweep, damping, which is no force of its scenes, and presses. */
const NOT_THERE = [
  ...['paper-step', 'speed-against-error', 'coasting', 'following'],
  'input-and-ticks',
]

test('there is a preset for every figure that a lab can show', () => {
  const shown = figurePresets.map(({ figure }) => figure)
  expect(shown).toEqual(figures.map(({ id }) => id).filter((id) => !NOT_THERE.includes(id)))
})

test.each(figurePresets)(
  '$figure: the lab runs what the figure runs',
  async ({ figure, shown }) => {
    const { controls, experiments } = await figures.find(({ id }) => id === figure)!.load()
    // A lab has one mass for all of its blocks.
    const [first] = sideBySide(experiments(initialValues(controls)))
    expect(shown).toEqual({ state: stateOf(first!), problem: '' })
  },
)
