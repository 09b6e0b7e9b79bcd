/** What each scene's law tells a step that it may rely on. */
import { describe, expect, it } from 'vitest'
import { exactMotion, scenes, simulate } from '../../src/physics/index.ts'
import type { Scene, SceneId } from '../../src/physics/index.ts'

/** The law of a scene at its defaults, but for some parameters. */
function lawOf(id: SceneId, given: Record<string, number> = {}) {
  const scene: Scene = scenes.find((each) => each.id === id)!
  const initial = Object.entries(scene.parameters).map(([name, { initial }]) => [name, initial])
  return scene.law({ ...(Object.fromEntries(initial) as Record<string, number>), ...given })
}

const smooth = { muStatic: 0, muKinetic: 0 }

describe('a law', () => {
  it('has the coefficients, the mass and the forces per mass of its parameters, and 0 for what a scene has not', () => {
    for (const id of ['ramp', 'run-out', 'half-pipe'] as const)
      expect(lawOf(id, { muStatic: 0.5, muKinetic: 0.4, mass: 3 })).toMatchObject({
        ...{ muStatic: 0.5, muKinetic: 0.4, mass: 3, stiffness: 0, drag: 0 },
      })
    expect(lawOf('spring', { stiffness: 12, mass: 3 })).toMatchObject({ stiffness: 4, drag: 0 })
    expect(lawOf('fall', { drag: 6, mass: 3 })).toMatchObject({
      ...{ muStatic: 0, muKinetic: 0, mass: 3, stiffness: 0, drag: 2 },
    })
  })

  it('says that a turn matters where friction or drag changes with it', () => {
    for (const id of ['ramp', 'run-out', 'half-pipe', 'spring'] as const) {
      expect(lawOf(id, smooth).turnMatters, id).toBe(false)
      expect(lawOf(id, { ...smooth, muStatic: 0.1 }).turnMatters, id).toBe(true)
    }
    expect(lawOf('fall').turnMatters).toBe(false)
    expect(lawOf('fall', { drag: 0.1 }).turnMatters).toBe(true)
  })

  it('has a track of pieces end to end, closed or open as the scene is', () => {
    const ends = scenes.map(({ id }) => {
      const { track } = lawOf(id)
      for (const [i, piece] of track.slice(1).entries()) expect(piece.from).toBe(track[i]!.to)
      return [id, track.length, track[0]!.from > -Infinity, track.at(-1)!.to < Infinity]
    })
    expect(ends).toEqual(
      expect.arrayContaining([
        ['fall', 1, false, false],
        ['ramp', 1, false, false],
        ['run-out', 3, false, false],
        ['half-pipe', 1, true, true],
        ['spring', 1, false, false],
      ]),
    )
    const [pipe] = lawOf('half-pipe', { radius: 3 }).track
    expect([pipe!.from, pipe!.to]).toEqual([-1.5 * Math.PI, 1.5 * Math.PI])
    const [, bend] = lawOf('run-out', { angle: 60, length: 2, bendRadius: 3 }).track
    expect(bend!.from).toBe(2)
    expect(bend!.to).toBeCloseTo(2 + Math.PI, 14)
  })

  it('bounds the speed far above what is real, closely for a spring', () => {
    for (const id of ['fall', 'ramp', 'run-out', 'half-pipe'] as const)
      expect(lawOf(id).speedLimit).toBe(1e15)
    expect(lawOf('spring', { stiffness: 0 }).speedLimit).toBe(1e15)
    // ω = 3/s: 3 · 2 m/s from where it starts, 9.81 · sin 30°/3 from the slope, 5 m/s of its own.
    const { speedLimit } = lawOf('spring', { stiffness: 18, mass: 2, position: -2, speed: -5 })
    expect(speedLimit).toBeCloseTo(1000 * (6 + 9.81 / 6 + 5), 8)
  })
})

describe('a ball without drag', () => {
  it('turns inside a step without being looked at', () => {
    const thrown = { scene: 'fall', parameters: { speed: -3.3 }, duration: 1 } as const
    const { evaluations, frames, s } = simulate(thrown)
    // One for the first step, and one in each, which serves the next.
    expect(evaluations).toBe(frames + 1)
    expect(s[60]).toBeCloseTo(exactMotion(thrown)(1, { s: 0, v: 0 }).s, 13)
  })
})

describe('friction under the naive rule', () => {
  it('has no direction at v = 0, as the sign of 0 has none', () => {
    for (const [angle, position] of [
      [30, 0],
      [10, 3],
    ] as const) {
      const experiment = {
        scene: 'ramp',
        parameters: { angle, position, muStatic: 0.5, muKinetic: 0.5 },
        integrator: 'explicit-euler',
        stopping: 'naive',
        duration: 1 / 60,
      } as const
      const [, v] = simulate(experiment).v
      expect(v).toBeCloseTo((9.81 * Math.sin((angle * Math.PI) / 180)) / 60, 14)
    }
  })
})
