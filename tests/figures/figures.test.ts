import { describe, expect, test } from 'vitest'
import { initialValues, nearestChoice, readValues } from '../../src/figures/shared/control.ts'
import type { Control, ControlValues } from '../../src/figures/shared/control.ts'
import type { Figure } from '../../src/figures/shared/figure.ts'
import { frameOf, heightOf, openingView } from '../../src/figures/shared/still.ts'
import { figures } from '../../src/figures/index.ts'
import { parseExperiment, simulate } from '../../src/physics/index.ts'

/** The values that a control's reader can reach which are most likely to go wrong. */
function extremes(control: Control): readonly unknown[] {
  if (control.type === 'number')
    return [control.from, control.to, nearestChoice(control, Math.E / 10)]
  if (control.type === 'choice') return control.options.map(({ id }) => id)
  return control.type === 'switch' ? [true, false] : [[1 / 60], [0.5, 0.004]]
}

/** A figure's values with each control once at each of its extremes. */
function variations({ controls, follow }: Figure): ControlValues[] {
  const initial = initialValues(controls)
  return Object.entries(controls).flatMap(([name, control]) =>
    extremes(control).map((value) => {
      const values = readValues(controls, { [name]: value }, initial)
      return follow?.(values, initial) ?? values
    }),
  )
}

describe.each(figures)('$id', ({ id, load }) => {
  test('its module is the one that the list names', async () => {
    const figure = await load()
    expect(figure.id).toBe(id)
    expect(figure.pictured).toMatch(/^\S.{20,}\.$/)
  })

  test('its experiments can be run and its sentences are whole, at every end of every control', async () => {
    const figure = await load()
    for (const values of [initialValues(figure.controls), ...variations(figure)]) {
      const experiments = figure.experiments(values)
      for (const experiment of experiments) parseExperiment(experiment)
      const runs = experiments.map(simulate)
      const end = figure.duration?.(values) ?? 0
      for (const time of [0, end / 2, end]) {
        const text = figure.says(values, runs, time)
        expect(text, JSON.stringify(values)).toMatch(/^[^\s].*[.…]$/)
        expect(text).not.toMatch(/undefined|NaN|Infinity|\d\.\d{6}|[^\d]-\d/)
        // As much as there is room for, or the page would move.
        expect(text.length).toBeLessThanOrEqual(240)
        for (const reading of figure.readings?.(values, runs, time) ?? [])
          expect(reading.text).not.toMatch(/undefined|NaN|no number/)
      }
    }
  })

  test('equal values give equal experiments', async () => {
    const figure = await load()
    const values = initialValues(figure.controls)
    expect(figure.experiments(values)).toEqual(figure.experiments({ ...values }))
  })

  test('its opening is in range, and on the sliders’ steps', async () => {
    const { controls } = await load()
    const initial = initialValues(controls)
    expect(readValues(controls, initial)).toEqual(initial)
  })

  test('its room is known before it is there', async () => {
    const figure = await load()
    expect(frameOf(figure)).toMatch(
      /^--shape-wide: [\d.]+; --below-wide: [\d.]+rem(; --hosted-wide: \d+rem)?; --shape-narrow: [\d.]+; --below-narrow: [\d.]+rem(; --hosted-narrow: \d+rem)?$/,
    )
    expect(heightOf(figure, 760)).toBeGreaterThan(150)
    const { runs, values } = openingView(figure)
    expect(runs).toHaveLength(figure.experiments(values).length)
  })
})

test('names are unique', () => {
  expect(new Set(figures.map(({ id }) => id)).size).toBe(figures.length)
})

describe('values', () => {
  const controls = {
    fps: { type: 'number', label: 'Frame rate', from: 5, to: 120, step: 0.5, initial: 15 },
    way: {
      type: 'choice',
      label: 'Way',
      options: [
        { id: 'a', label: 'A' },
        { id: 'b', label: 'B' },
      ],
      initial: 'a',
    },
    on: { type: 'switch', label: 'On', about: { on: '', off: '' }, initial: false },
    frames: { type: 'frames', label: 'Frames', initial: [0.01] },
  } as const

  test('come from addresses too, and numbers are taken to the slider', () => {
    expect(readValues(controls, { fps: '30', way: 'b', on: 'true' })).toEqual({
      ...{ fps: 30, way: 'b', on: true },
      frames: [0.01],
    })
    expect(readValues(controls, { fps: 1000 }).fps).toBe(120)
    expect(readValues(controls, { fps: 7.3 }).fps).toBe(7.5)
    const before = { fps: 60, way: 'b', on: true, frames: [0.02] }
    expect(readValues(controls, { fps: 5 }, before)).toEqual({ ...before, fps: 5 })
  })

  const wrong: readonly Record<string, unknown>[] = [
    { speed: 1 },
    { fps: 'fast' },
    { fps: '' },
    { fps: NaN },
    { fps: Infinity },
    { way: 'c' },
    { on: 'maybe' },
    { frames: [] },
    { frames: [0] },
    { toString: 1 },
  ]
  test.each(wrong)('that can’t be are refused: %j', (given) => {
    expect(() => readValues(controls, given)).toThrow(RangeError)
  })
})
