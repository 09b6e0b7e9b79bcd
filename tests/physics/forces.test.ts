import { describe, expect, it } from 'vitest'
import { forcesAt, scenes } from '../../src/physics/index.ts'
import type { Experiment, Scene } from '../../src/physics/index.ts'
import { Motion } from '../../src/physics/motion.ts'
import { dot, length } from '../../src/physics/vector.ts'

const states = [
  { s: 0.3, v: 1.7 },
  { s: 1.1, v: -2.4 },
  { s: 4.5, v: 3 },
  { s: -0.7, v: 0.2 },
]

const experiments: Experiment[] = [
  { scene: 'fall', parameters: { drag: 0.4, mass: 3 } },
  { scene: 'ramp', parameters: { mass: 2.5, angle: 37 } },
  { scene: 'run-out', parameters: { mass: 1.3, angle: 50 } },
  { scene: 'half-pipe', parameters: { mass: 0.7, radius: 4, muKinetic: 0.3, muStatic: 0.4 } },
  { scene: 'spring', parameters: { mass: 4, stiffness: 90 } },
  { scene: 'crest', parameters: { mass: 1.7, angle: 25, crestRadius: 4 } },
  { scene: 'belt', parameters: { mass: 2, beltSpeed: 0.8 } },
]

describe('the force vectors', () => {
  it('are tested in every scene', () => {
    expect(experiments.map(({ scene }) => scene).sort()).toEqual(scenes.map(({ id }) => id).sort())
  })

  describe.each(experiments)('in $scene', (experiment) => {
    const scene: Scene = scenes.find(({ id }) => id === experiment.scene)!
    const parameters = {
      ...Object.fromEntries(
        Object.entries(scene.parameters).map(([name, { initial }]) => [name, initial]),
      ),
      ...experiment.parameters,
    } as Record<string, number>
    const law = scene.law(parameters)

    it.each(states)(
      'add up along the track to the acceleration that a step integrates, and across to m v² κ, at %o',
      (state) => {
        const forces = forcesAt(experiment, state)
        const motion = new Motion(law, state.s, state.v, true)
        const scale = length(forces.gravity) + length(forces.normal) + length(forces.other)
        // Ten roundings of the largest of the forces.
        const rounding = 10 * Number.EPSILON * scale
        const along = dot(forces.sum, forces.along)
        expect(Math.abs(along - law.mass * motion.acceleration(state.s, state.v))).toBeLessThan(
          rounding,
        )
        const { curvature } = scene.place(parameters, state.s)
        const across = dot(forces.sum, forces.across)
        // A falling ball has no track to be across of.
        const centripetal = law.mass * state.v ** 2 * curvature
        expect(Math.abs(across - centripetal)).toBeLessThan(rounding)
        expect(length(forces.acceleration) * law.mass).toBeCloseTo(length(forces.sum), 10)
        expect(length(forces.along)).toBeCloseTo(1, 15)
        expect(Math.abs(dot(forces.along, forces.across))).toBeLessThan(1e-15)
      },
    )

    it('friction opposes the sliding with μk N', () => {
      for (const state of states) {
        const { friction, normal, along } = forcesAt(experiment, state)
        const expected = -Math.sign(state.v - law.belt) * law.muKinetic * length(normal)
        expect(dot(friction, along)).toBeCloseTo(expected, 12)
      }
    })
  })

  it('of a block that stays add up to nothing: static friction is what holds it, not μs N', () => {
    const resting: Experiment = {
      scene: 'ramp',
      parameters: { angle: 10, muStatic: 0.5, muKinetic: 0.4 },
    }
    const { friction, normal, sum } = forcesAt(resting, { s: 0, v: 0 })
    expect(length(sum)).toBeLessThan(1e-14)
    expect(length(friction)).toBeCloseTo(9.81 * Math.sin((10 * Math.PI) / 180), 12)
    expect(length(friction)).toBeLessThan(0.5 * length(normal))
  })

  it('of a block that can’t be held are those of sliding', () => {
    const steep: Experiment = {
      scene: 'ramp',
      parameters: { angle: 40, muStatic: 0.5, muKinetic: 0.4 },
    }
    const { friction, normal, along } = forcesAt(steep, { s: 0, v: 0 })
    expect(dot(friction, along)).toBeCloseTo(-0.4 * length(normal), 12)
  })

  it('of a block under the naive rule, at exactly v = 0, know no friction: it can’t be held', () => {
    const slope: Experiment = { scene: 'ramp', parameters: { angle: 10 }, stopping: 'naive' }
    const { friction, frictionKind } = forcesAt(slope, { s: 0, v: 0 })
    expect(length(friction)).toBe(0)
    expect(frictionKind).toBe('none')
    expect(forcesAt(slope, { s: 0, v: 1 }).frictionKind).toBe('sliding')
    expect(forcesAt({ ...slope, stopping: 'clamped' }, { s: 0, v: 0 }).frictionKind).toBe('held')
  })

  it('hold a block up to the very limit of static friction', () => {
    // The spring pulls with 4 · 0.5 N, and friction can hold ¼ · 8 N.
    const limit: Experiment = {
      scene: 'spring',
      parameters: { angle: 0, stiffness: 4, gravity: 8, muStatic: 0.25, muKinetic: 0.25 },
    }
    expect(forcesAt(limit, { s: 0.5, v: 0 }).frictionKind).toBe('held')
    expect(forcesAt(limit, { s: 0.5 + 1e-15, v: 0 }).frictionKind).toBe('sliding')
  })

  it('have no friction where its coefficients are 0, at rest or sliding', () => {
    const ice: Experiment = { scene: 'ramp', parameters: { angle: 0, muStatic: 0, muKinetic: 0 } }
    for (const v of [0, 1, -1]) {
      const { frictionKind, friction } = forcesAt(ice, { s: 0, v })
      expect(frictionKind).toBe('none')
      expect(length(friction)).toBe(0)
    }
  })

  it('leave no normal force on a wall', () => {
    expect(
      length(forcesAt({ scene: 'ramp', parameters: { angle: 90 } }, { s: 0, v: 1 }).normal),
    ).toBe(0)
  })
})
