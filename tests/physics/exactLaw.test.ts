import { describe, expect, it } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { Scene } from '../../src/physics/index.ts'
import { Random } from '../../src/physics/random.ts'
import { samples } from '../samples.ts'
import { endOf, jointsOf } from './joints.ts'

const random = new Random(11)
const uniform = (from: number, to: number) => from + ((to - from) * random.next()) / 2 ** 32

const ranges: Record<string, [number, number]> = {
  gravity: [1, 20],
  mass: [0.5, 3],
  drag: [0, 1],
  angle: [0, 89],
  muStatic: [0, 1],
  muKinetic: [0, 0.6],
  length: [0, 4],
  bendRadius: [0.5, 3],
  radius: [1, 3],
  crestRadius: [0.5, 3],
  beltSpeed: [-2, 2],
  stiffness: [0, 300],
  position: [-1.5, 4],
  speed: [-8, 8],
}

/** The acceleration, as PHYSICS.md has it, by the place on the track alone; undefined for a block that stays. */
function acceleration(scene: Scene, given: Record<string, number>, s: number, v: number) {
  const { gravity = 0, mass = 1, drag = 0, muKinetic = 0, muStatic = 0, stiffness = 0 } = given
  const { slope, curvature } = scene.place(given, s)
  const drive = gravity * Math.sin(slope) - (stiffness / mass) * s - (drag / mass) * v * Math.abs(v)
  const press = gravity * Math.cos(slope) + curvature * v * v
  // A block that stays is allowed to by the last bit of both forces.
  const { beltSpeed = 0 } = given
  if (v === beltSpeed && Math.abs(drive) <= Math.max(muStatic, muKinetic) * press + 1e-13)
    return beltSpeed === 0 ? undefined : 0
  return drive - Math.sign(v - beltSpeed) * muKinetic * press
}

/** The derivative at the middle of seven equally spaced values, of sixth order. */
function derivative(f: readonly number[], h: number): number {
  return (45 * (f[4]! - f[2]!) - 9 * (f[5]! - f[1]!) + f[6]! - f[0]!) / (60 * h)
}

describe.each(scenes)('the exact motion on the scene $id', (scene: Scene) => {
  it('obeys the law at every instant between two jumps', () => {
    const h = 1e-3
    let checked = 0
    for (let run = 0; run < samples(300); run++) {
      const given = Object.fromEntries(
        Object.keys(scene.parameters).map((name) => [name, uniform(...ranges[name]!)]),
      )
      if (scene.conflict?.(given)) continue
      const motion = scene.exact(given)
      const end = endOf(scene, given)
      const joints = [...jointsOf(scene, given), end, -end]
      for (let i = 0; i < 20; i++) {
        const t = uniform(3 * h, 4)
        const states = [-3, -2, -1, 0, 1, 2, 3].map((k) => motion(t + k * h, { s: 0, v: 0 }))
        const { s, v } = states[3]!
        const [first, last] = [states[0]!, states[6]!]
        const { beltSpeed = 0 } = given
        const stands = states.map((each, k) => k > 0 && each.s === states[k - 1]!.s && each.v !== 0)
        const jumps =
          states.some((each) => Math.sign(each.v - beltSpeed) !== Math.sign(v - beltSpeed)) ||
          (stands[6] && !stands[1]) ||
          joints.some((joint) => Math.sign(first.s - joint) !== Math.sign(last.s - joint))
        if (jumps) continue
        checked++
        const a = acceleration(scene, given, s, v)
        if (Math.abs(s) >= end || stands[6]) {
          // Left the track, at its end or where the press falls to 0: nothing changes any more.
          expect(first).toEqual(last)
          // At a joint, on the piece ahead.
          const { slope, curvature } = scene.place(given, s + 1e-9 * Math.sign(v))
          const press = given.gravity! * Math.cos(slope) + curvature * v * v
          if (Math.abs(s) < end) expect(press).toBeLessThanOrEqual(1e-8 * given.gravity!)
        } else if (a === undefined) {
          expect([first, last]).toEqual([
            { s, v: 0 },
            { s, v: 0 },
          ])
        } else {
          // Truncation: (rate h)⁶/140 of a · rate, at rates up to 20/s 1e-11 a; rounding: an ulp of s or v over h.
          expect(v).not.toBe(0)
          const speed = derivative(
            states.map((each) => each.s),
            h,
          )
          const gain = derivative(
            states.map((each) => each.v),
            h,
          )
          expect(Math.abs(speed - v), JSON.stringify({ ...given, t })).toBeLessThanOrEqual(
            1e-10 * (1 + Math.abs(s) + Math.abs(v)),
          )
          expect(Math.abs(gain - a), JSON.stringify({ ...given, t })).toBeLessThanOrEqual(
            1e-9 * (1 + Math.abs(v) + Math.abs(a)),
          )
        }
      }
    }
    expect(checked).toBeGreaterThan(samples(1500))
  })
})
