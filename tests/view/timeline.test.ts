import { expect, test } from 'vitest'
import { simulate } from '../../src/physics/index.ts'
import { endOf, frameRate, rowAt } from '../../src/view/timeline.ts'

const kicked = {
  scene: 'ramp',
  parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  duration: 1,
} as const

test('the row shown is that of the last frame, from the very time of the frame on', () => {
  const trajectory = simulate({ ...kicked, frames: { kind: 'steady', fps: 10 } })
  expect([0, 0.05, 0.0999, 0.1, 0.3, 0.35, 1, 9].map((t) => rowAt(trajectory, t))).toEqual([
    0, 0, 0, 1, 3, 3, 10, 10,
  ])
  expect(frameRate(trajectory)).toBe(10)
})

test('a stop is shown with the first frame after it, and told by the wall clock', () => {
  const stop = 5 / (9.81 * (Math.sin(Math.PI / 12) + 0.5 * Math.cos(Math.PI / 12)))
  const variable = endOf(simulate({ ...kicked, frames: { kind: 'steady', fps: 10 } }))!
  expect(variable).toEqual({ kind: 'at-rest', row: 7, time: expect.closeTo(stop, 9) })
  // The classic bug at 10 fps: 1/60 s of motion in every tenth of a second.
  const crawling = simulate({
    ...kicked,
    duration: 6,
    frames: { kind: 'steady', fps: 10 },
    timestep: { kind: 'per-frame', step: 1 / 60 },
  })
  expect(endOf(crawling)!.time).toBeCloseTo(6 * stop, 6)
})

test('a run that goes on has no end', () => {
  expect(endOf(simulate({ scene: 'fall' }))).toBeUndefined()
})
