import { scenes } from '../../src/physics/index.ts'
import type { ExactMotion, Scene } from '../../src/physics/index.ts'

export const byId = (id: string): Scene => scenes.find((scene) => scene.id === id)!
export const bare = { gravity: 9.81, mass: 1, muStatic: 0, muKinetic: 0, position: 0, speed: 0 }
export const ramp = (given: object) => byId('ramp').exact({ angle: 30, ...bare, ...given })
export const runOut = (given: object) =>
  byId('run-out').exact({ angle: 30, length: 4, bendRadius: 1.5, ...bare, ...given })
export const halfPipe = (given: object) => byId('half-pipe').exact({ radius: 2, ...bare, ...given })
export const at = (motion: ExactMotion, t: number) => motion(t, { s: NaN, v: NaN })

/** The instants at which the sign of v changes or a joint is crossed, to an ulp. */
export function breaks(motion: ExactMotion, duration: number, joints: readonly number[]): number[] {
  const side = (t: number) => {
    const { s, v } = at(motion, t)
    return Math.sign(v) + 10 * joints.filter((joint) => s >= joint).length
  }
  const found: number[] = []
  const add = (from: number, to: number): void => {
    let [low, high] = [from, to]
    const start = side(low)
    for (let middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2) {
      if (side(middle) === start) low = middle
      else high = middle
    }
    found.push(high)
    // Another may follow within the same part. At a turning point itself v may be 0: that is the same one.
    const next = high * (1 + 4 * Number.EPSILON)
    if (next < to && side(next) !== side(to)) add(next, to)
  }
  for (let i = 0; i < 4000; i++) {
    const [from, to] = [(duration * i) / 4000, (duration * (i + 1)) / 4000]
    if (from > 0 && side(from) !== side(to)) add(from, to)
  }
  return found
}

/** The integral by Gauss's rule with three points, which asks for no value at the very ends, in 500 parts. */
export function integral(f: (t: number) => number, from: number, to: number): number {
  const h = (to - from) / 500
  const reach = (h / 2) * Math.sqrt(0.6)
  let sum = 0
  for (let i = 0; i < 500; i++) {
    const middle = from + (i + 0.5) * h
    sum += 5 * f(middle - reach) + 8 * f(middle) + 5 * f(middle + reach)
  }
  return (sum * h) / 18
}
