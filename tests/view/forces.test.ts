import { describe, expect, test } from 'vitest'
import { forcesAt } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { actorsOf } from '../../src/view/actors.ts'
import { forceArrows } from '../../src/view/forces.ts'
import type { ForceArrow } from '../../src/view/forces.ts'
import { handlesOf } from '../../src/view/handles.ts'
import { around } from '../../src/chart/geometry.ts'
import { layOut } from '../../src/view/layout.ts'
import { physicsOf } from '../../src/view/physicsOutline.ts'
import type { Picture, PictureForces } from '../../src/view/picture.ts'
import { Projection } from '../../src/view/projection.ts'
import { rowAt } from '../../src/view/timeline.ts'
import { pictureOf } from './pictures.ts'

const ids = ['gravity', 'normal', 'friction', 'other', 'sum'] as const

/** The picture of an experiment at a time, with the forces on its first runner. */
function withForces(experiment: Experiment, time: number): Picture & { forces: PictureForces } {
  const picture = { ...pictureOf(experiment), time, selected: 0 }
  const { s, v } = picture.runners[0]!.trajectory
  const row = rowAt(picture.runners[0]!.trajectory, time)
  const forces = forcesAt(experiment, { s: s[row]!, v: v[row]! })
  const { along, across } = forces
  const vectors = [
    ...ids.map((id) => ({ id, tag: id[0]!, ...forces[id] })),
    { id: 'velocity' as const, tag: 'v', x: v[row]! * along.x, y: v[row]! * along.y },
  ]
  return { ...picture, forces: { vectors, along, across, largest: 40, fastest: 10 } }
}

function arrowsOf(picture: Picture, width = 1180, height = 448) {
  const layout = layOut(picture, width, height)
  const projection = new Projection(picture.scene, picture.parameters, layout.camera)
  const [actor] = actorsOf(picture, layout, projection)
  const room = handlesOf(picture, layout).map((handle) => around(handle, 8))
  return { layout, actor: actor!, arrows: forceArrows(picture, actor!, layout, room), room }
}

const lengthOf = ({ from, to }: ForceArrow) => Math.hypot(to.x - from.x, to.y - from.y)

const experiments: [Experiment, number][] = [
  [{ scene: 'fall', parameters: { drag: 0.2 } }, 0.8],
  [{ scene: 'ramp', parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 } }, 0.3],
  [{ scene: 'run-out' }, 1.5],
  [{ scene: 'half-pipe' }, 1],
  [{ scene: 'spring', parameters: { position: 1.5 } }, 0.4],
]

describe.each(experiments)('$scene', (experiment, time) => {
  const picture = withForces(experiment, time)

  test('arrows are as long as their forces are large, to one scale', () => {
    const { arrows, layout } = arrowsOf(picture)
    expect(arrows.length).toBeGreaterThan(2)
    for (const arrow of arrows) {
      const vector = picture.forces.vectors.find(({ id }) => id === arrow.id)!
      const most = arrow.id === 'velocity' ? 10 : 40
      expect(lengthOf(arrow)).toBeCloseTo((layout.force * Math.hypot(vector.x, vector.y)) / most, 9)
    }
  })

  test('they point where the forces do, as the scene is shown', () => {
    for (const { id, from, to } of arrowsOf(picture).arrows) {
      const { x, y } = picture.forces.vectors.find((vector) => vector.id === id)!
      const scale = Math.hypot(to.x - from.x, to.y - from.y) / Math.hypot(x, y)
      expect(to.x - from.x).toBeCloseTo(picture.scene.facing * x * scale, 9)
      expect(to.y - from.y).toBeCloseTo(-y * scale, 9)
    }
  })

  test('gravity’s parts add up to it, where it has two', () => {
    const gravity = arrowsOf(picture).arrows.find(({ id }) => id === 'gravity')!
    if (experiment.scene === 'fall') return expect(gravity.parts).toEqual([])
    const [along, across] = gravity.parts as [typeof gravity.to, typeof gravity.to]
    expect(along.x + across.x - gravity.from.x).toBeCloseTo(gravity.to.x, 9)
    expect(along.y + across.y - gravity.from.y).toBeCloseTo(gravity.to.y, 9)
  })

  test.each([
    [1180, 448],
    [350, 304],
  ])('letters are on a canvas of %d × %d and clear of each other', (width, height) => {
    const { arrows } = arrowsOf(picture, width, height)
    arrows.forEach(({ box }, i) => {
      expect(box.left).toBeGreaterThan(-1)
      expect(box.right).toBeLessThan(width + 1)
      expect(box.top).toBeGreaterThan(-1)
      expect(box.bottom).toBeLessThan(height + 1)
      for (const { box: other } of arrows.slice(i + 1)) {
        const apart = box.left >= other.right || other.left >= box.right
        expect(apart || box.top >= other.bottom || other.top >= box.bottom).toBe(true)
      }
    })
  })
})

test('what is nothing has no arrow', () => {
  const flat = withForces({ scene: 'ramp', parameters: { angle: 0, speed: 0 } }, 1)
  expect(arrowsOf(flat).arrows.map(({ id }) => id)).toEqual(['gravity', 'normal'])
  const { arrows } = arrowsOf({ ...flat, forces: { ...flat.forces, largest: 0, fastest: 0 } })
  expect(arrows).toEqual([])
})

test('without forces there are no arrows, and the view is as it was', () => {
  const picture = withForces({ scene: 'ramp' }, 0.5)
  const calm = { ...picture, forces: undefined }
  expect(arrowsOf(calm).arrows).toEqual([])
  expect(arrowsOf(calm).layout).toEqual(layOut(pictureOf({ scene: 'ramp' }), 1180, 448))
})

test('the arrows of a run that blows up are cut, and said to be', () => {
  const picture = withForces({ scene: 'ramp', parameters: { angle: 15 } }, 0.5)
  const { arrows, layout } = arrowsOf({ ...picture, forces: { ...picture.forces, largest: 2 } })
  for (const arrow of arrows) expect(lengthOf(arrow)).toBeLessThan(1.5 * layout.force + 1e-9)
  expect(arrows.find(({ id }) => id === 'gravity')!.cut).toBe(true)
})

test.each([
  ['latest', false],
  ['interpolated', true],
  ['extrapolated', true],
] as const)('drawn %s, physics is elsewhere: %s', (draw, apart) => {
  const timestep = { kind: 'fixed', step: 0.05, draw } as const
  const picture = { ...pictureOf({ scene: 'ramp', parameters: { angle: 30 }, timestep }, [144]) }
  const shown = { ...picture, time: 0.8 + 3 / 144 }
  const layout = layOut(shown, 720, 420)
  const projection = new Projection(shown.scene, shown.parameters, layout.camera)
  const found = physicsOf(actorsOf(shown, layout, projection)[0]!, shown, layout, projection)
  expect(found !== undefined).toBe(apart)
  if (!found) return
  const ahead = found.physics.spot.y - found.drawn.spot.y
  // Interpolated is behind the physics and so higher on the slope, extrapolated ahead of it.
  expect(Math.sign(ahead)).toBe(draw === 'interpolated' ? 1 : -1)
})
