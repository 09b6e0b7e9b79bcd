import { expect, test } from 'vitest'
import { graphIn } from '../../src/chart/graph.ts'
import { angleTowards, slopeThrough } from '../../src/figures/shared/slope.ts'
import { moved } from '../../src/chart/geometry.ts'

const box = { left: 40, right: 240, top: 10, bottom: 110 }

test('a graph’s corners are where its axes begin and end, whichever way they go', () => {
  const { x, y } = graphIn(box, [0, 2], [-1, 3])
  expect([x(0), x(2), y(-1), y(3)]).toEqual([40, 240, 110, 10])
  const down = graphIn(box, [0, 2], [5, 0])
  expect([down.y(0), down.y(5), down.y(2.5)]).toEqual([10, 110, 60])
})

test.each([0, 12.5, 30, 60])(
  'a slope of %d° goes uphill to the right, and is found again',
  (angle) => {
    const at = { x: 100, y: 200 }
    const { along, out } = slopeThrough(at, angle)
    const uphill = moved(at, along, -150)
    expect(uphill.x).toBeGreaterThan(at.x)
    expect(uphill.y).toBeLessThanOrEqual(at.y)
    expect(angleTowards(at, uphill)).toBeCloseTo(angle, 12)
    expect(along.x * out.x + along.y * out.y).toBeCloseTo(0, 15)
    // Out of the ground is up.
    expect(out.y).toBeLessThan(0)
  },
)
