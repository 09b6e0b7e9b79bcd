import type { Motion } from '../../src/physics/motion.ts'

/** What an integrator needs of a motion and no more, with any acceleration: for steps that no scene asks for. */
export function bareMotion(
  acceleration: (s: number, v: number) => number,
  { s = 0, v = 0, dt = 1 }: { s?: number; v?: number; dt?: number },
): Motion {
  const motion = {
    ...{ s, v, dt, a: NaN, known: false, reusable: false, evaluations: 0, unsolved: 0 },
    acceleration(atS: number, atV: number) {
      motion.evaluations++
      return acceleration(atS, atV)
    },
  }
  return motion as unknown as Motion
}
