import { expect, test } from 'vitest'
import { toTolerance } from '../../src/physics/timesteps/tolerance.ts'
import { placeOf, stepped, valueAt } from '../../src/ui/sliderScale.ts'

const linear = { from: 0, to: 1, step: 0.1 }
const { slider } = toTolerance.options.tolerance

test('a linear slider stands at its number, and steps add up without rounding', () => {
  expect(placeOf(linear, 0.3)).toBe(0.3)
  expect(stepped(linear, 0.2, 1)).toBe(0.3)
  expect(stepped(linear, 0.2, -10)).toBe(-0.8)
})

test('a logarithmic slider goes through 1, 2 and 5 of every power of ten, up and down', () => {
  const up: number[] = []
  for (let value: number = slider.from; value <= slider.to; value = stepped(slider, value, 1))
    up.push(value)
  expect(up.slice(0, 4)).toEqual([1e-12, 2e-12, 5e-12, 1e-11])
  expect(up.at(-1)).toBe(slider.to)
  expect(up).toHaveLength(28)
  const down: number[] = []
  for (let value: number = slider.to; value >= slider.from; value = stepped(slider, value, -1))
    down.push(value)
  expect(down.reverse()).toEqual(up)
})

test('each of its numbers is where its place is', () => {
  for (const value of [1e-12, 2e-9, 5e-4, 1e-3])
    expect(valueAt(slider, placeOf(slider, value))).toBe(value)
})

test('from a number between its places it goes on to one of them', () => {
  expect(stepped(slider, 3.7e-6, 1)).toBe(1e-5)
  expect(stepped(slider, 3.7e-6, -1)).toBe(2e-6)
})
