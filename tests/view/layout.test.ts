import { describe, expect, test } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { bodyAt } from '../../src/view/actors.ts'
import { boundsOf } from '../../src/view/body.ts'
import { dragged } from '../../src/view/drag.ts'
import { withParameter, handleAt, handlesOf } from '../../src/view/handles.ts'
import { held, layOut } from '../../src/view/layout.ts'
import { Projection } from '../../src/view/projection.ts'
import { pictureOf } from './pictures.ts'

const sizes = [
  [1180, 460],
  [720, 420],
  [350, 300],
  [310, 240],
] as const

const experiments: Experiment[] = [
  ...scenes.map(({ id }) => ({ scene: id })),
  {
    scene: 'ramp',
    parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
    duration: 1,
  },
  { scene: 'ramp', parameters: { angle: 90, speed: -9 } },
  { scene: 'ramp', parameters: { angle: 0, speed: 9 } },
  { scene: 'ramp', parameters: { angle: 30, speed: 2, position: 40 }, duration: 3 },
  { scene: 'ramp', parameters: { angle: 5 } },
  { scene: 'fall', parameters: { speed: -50 } },
  { scene: 'run-out', parameters: { length: 5, muKinetic: 0.05, muStatic: 0.05 }, duration: 12 },
  { scene: 'half-pipe', parameters: { position: 3.1 }, integrator: 'explicit-euler' },
  { scene: 'spring', parameters: { stiffness: 4000 }, integrator: 'explicit-euler', duration: 2 },
]

describe.each(experiments)('$scene $parameters', (experiment) => {
  const picture = pictureOf(experiment)

  test.each(sizes)('fits on %d × %d with all its handles', (width, height) => {
    const layout = layOut(picture, width, height)
    const projection = new Projection(picture.scene, picture.parameters, layout.camera)
    const { from, to } = layout.extent
    for (const s of [from, (from + to) / 2, to, picture.parameters.position!]) {
      const { left, top, right, bottom } = boundsOf(bodyAt(s, picture, layout, projection))
      expect(left).toBeGreaterThan(-1)
      expect(right).toBeLessThan(width + 1)
      expect(top).toBeGreaterThan(-1)
      expect(bottom).toBeLessThan(height + 1)
    }
    for (const { x, y } of handlesOf(picture, layout)) {
      expect(x).toBeGreaterThan(8)
      expect(x).toBeLessThan(width - 8)
      expect(y).toBeGreaterThan(8)
      expect(y).toBeLessThan(height - 8)
    }
  })

  test('a handle that is let go where it is changes nothing but the last digits', () => {
    const layout = layOut(picture, 720, 420)
    for (const { id, x, y, parameter } of handlesOf(picture, layout)) {
      const value = dragged(id, { x, y }, picture, layout)[parameter]!
      const after = handleAt(id, withParameter(picture, parameter, value), layout)
      expect(Math.hypot(after.x - x, after.y - y)).toBeLessThan(5)
    }
  })
})

test('the ramp’s end follows the finger in a held view, about a foot that keeps still', () => {
  for (const scene of ['ramp', 'run-out', 'spring'] as const) {
    const start = pictureOf({ scene })
    const layout = layOut(start, 720, 420)
    for (const angle of [10, 20, 42.5, 60]) {
      const tilted = pictureOf({ scene, parameters: { angle } })
      const view = held(layout, tilted)
      expect(view.camera.scale).toBe(layout.camera.scale)
      const { x, y } = handleAt('tilt', tilted, view)
      expect(dragged('tilt', { x, y }, start, layout)).toEqual({ angle })
    }
  }
})

test('the arrow pulled through the block pushes the other way; let go in the block, not at all', () => {
  const picture = pictureOf({ scene: 'ramp', parameters: { angle: 0 } })
  const layout = layOut(picture, 720, 420)
  const { x, y } = handleAt('place', picture, layout)
  expect(dragged('push', { x, y }, picture, layout)).toEqual({ speed: 0 })
  // Growing s is to the left in this scene.
  expect(dragged('push', { x: x + 120, y }, picture, layout).speed).toBeLessThan(-1)
  expect(dragged('push', { x: x - 120, y }, picture, layout).speed).toBeGreaterThan(1)
})

test('a block is not placed outside the pipe', () => {
  const picture = pictureOf({ scene: 'half-pipe' })
  const layout = layOut(picture, 720, 420)
  for (const x of [-500, 100, 700, 5000]) {
    const { position } = dragged('place', { x, y: -300 }, picture, layout)
    expect(Math.abs(position!)).toBeLessThan(Math.PI)
  }
})

test('a small change of a slider is a small change of the camera', () => {
  let before = layOut(
    pictureOf({ scene: 'ramp', parameters: { angle: 20, speed: -5 } }),
    720,
    420,
  ).camera
  for (let angle = 20; angle < 21; angle += 0.02) {
    const { camera } = layOut(
      pictureOf({ scene: 'ramp', parameters: { angle, speed: -5 } }),
      720,
      420,
    )
    expect(Math.abs(camera.scale / before.scale - 1)).toBeLessThan(0.05)
    before = camera
  }
})

test('a run that diverges does not shrink the picture to a point', () => {
  const experiment: Experiment = {
    scene: 'spring',
    parameters: { stiffness: 1000, position: 0.2, muKinetic: 0, muStatic: 0 },
    integrator: 'explicit-euler',
  }
  const { extent } = layOut(pictureOf(experiment), 720, 420)
  expect(extent.to - extent.from).toBeLessThan(3 * 0.5)
})
