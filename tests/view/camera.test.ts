import { expect, test } from 'vitest'
import { fit } from '../../src/view/projection.ts'

const at = (x: number, y: number, room = 0) => ({
  x,
  y,
  left: room,
  right: room,
  above: room,
  below: room,
})

test('the camera sees every subject with its room, and is as large as that allows', () => {
  const subjects = [at(0, 0, 10), at(4, 1, 30), { ...at(2, -1, 5), above: 60 }]
  const { scale, x, y } = fit(subjects, 400, 300)
  for (const subject of subjects) {
    expect(x + scale * subject.x - subject.left).toBeGreaterThan(-0.01)
    expect(x + scale * subject.x + subject.right).toBeLessThan(400.01)
    expect(y - scale * subject.y - subject.above).toBeGreaterThan(-0.01)
    expect(y - scale * subject.y + subject.below).toBeLessThan(300.01)
  }
  // 4 m and 40 px of room across.
  expect(scale).toBeCloseTo(90, 3)
})

test('what is seen stands in the middle', () => {
  const { scale, x, y } = fit([at(-1, 0), at(1, 0)], 200, 100)
  expect([scale, x, y]).toEqual([expect.closeTo(100, 3), expect.closeTo(100, 3), 50])
})

test('a small change of the subjects is a small change of the camera', () => {
  let before = fit([at(0, 0, 20), at(3, 1, 40)], 350, 300)
  for (let i = 1; i <= 200; i++) {
    const camera = fit([at(0, 0, 20), at(3 + i / 100, 1 + i / 50, 40)], 350, 300)
    expect(Math.abs(camera.scale / before.scale - 1)).toBeLessThan(0.02)
    expect(Math.abs(camera.x - before.x)).toBeLessThan(3)
    before = camera
  }
})

test('kilometres and millimetres', () => {
  expect(fit([at(0, 0), at(1e6, 0)], 100, 100).scale).toBeCloseTo(1e-4, 9)
  expect(fit([at(0, 0), at(1e-6, 0)], 100, 100).scale / 1e8).toBeCloseTo(1, 6)
})

test('on a canvas that the room around them would fill, they still have a fifth of it', () => {
  for (const height of [20, 60, 90, 120]) {
    const { scale, y } = fit([at(0, 0, 60), at(1, 2, 60)], 400, height)
    expect(2 * scale).toBeCloseTo(0.2 * height, 6)
    expect(y).toBeCloseTo(0.6 * height, 6)
  }
  // Rooms that just fit change nothing, so that no picture jumps while its canvas grows.
  const [lower, higher] = [149.99, 150.01].map(
    (height) => fit([at(0, 0, 60), at(1, 2, 60)], 400, height).scale,
  )
  expect(higher! / lower!).toBeCloseTo(1, 3)
})
