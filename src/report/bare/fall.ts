import { INNER, OUTER, ROUNDING } from './constants.ts'
import type { End, Given } from './bareLoop.ts'

/** A ball that starts downwards or at rest. The scene’s constants; k is the drag per mass. */
function air({ gravity, mass, drag, position, speed }: Given) {
  return { gravity: gravity!, k: drag! / mass!, position: position!, speed: speed! }
}

/** Explicit Euler. */
export function explicitEuler(given: Given, dt: number, steps: number): End {
  const { gravity, k, position, speed } = air(given)
  let s = position
  let v = speed
  for (let n = 0; n < steps; n++) {
    const a = gravity - k * v * Math.abs(v)
    const s1 = s + v * dt
    const v1 = v + a * dt
    s = s1
    v = v1
  }
  return { s, v, heat: 0 }
}

/** Semi-implicit Euler. */
export function semiImplicitEuler(given: Given, dt: number, steps: number): End {
  const { gravity, k, position, speed } = air(given)
  let s = position
  let v = speed
  for (let n = 0; n < steps; n++) {
    const a = gravity - k * v * Math.abs(v)
    const v1 = v + a * dt
    const s1 = s + v1 * dt
    s = s1
    v = v1
  }
  return { s, v, heat: 0 }
}

/** Velocity Verlet. */
export function velocityVerlet(given: Given, dt: number, steps: number): End {
  const { gravity, k, position, speed } = air(given)
  let s = position
  let v = speed
  for (let n = 0; n < steps; n++) {
    const a = gravity - k * v * Math.abs(v)
    const s1 = s + (v + 0.5 * a * dt) * dt
    const a1Speed = v + a * dt
    const a1 = gravity - k * a1Speed * Math.abs(a1Speed)
    const v1 = v + 0.5 * (a + a1) * dt
    s = s1
    v = v1
  }
  return { s, v, heat: 0 }
}

/** The midpoint method. */
export function midpoint(given: Given, dt: number, steps: number): End {
  const { gravity, k, position, speed } = air(given)
  let s = position
  let v = speed
  for (let n = 0; n < steps; n++) {
    const a = gravity - k * v * Math.abs(v)
    const vHalf = v + 0.5 * dt * a
    const aHalf = gravity - k * vHalf * Math.abs(vHalf)
    const s1 = s + vHalf * dt
    const v1 = v + aHalf * dt
    s = s1
    v = v1
  }
  return { s, v, heat: 0 }
}

/** The classical Runge–Kutta method. */
export function rk4(given: Given, dt: number, steps: number): End {
  const { gravity, k, position, speed } = air(given)
  let s = position
  let v = speed
  for (let n = 0; n < steps; n++) {
    const a1 = gravity - k * v * Math.abs(v)
    const v2 = v + 0.5 * dt * a1
    const a2 = gravity - k * v2 * Math.abs(v2)
    const v3 = v + 0.5 * dt * a2
    const a3 = gravity - k * v3 * Math.abs(v3)
    const v4 = v + dt * a3
    const a4 = gravity - k * v4 * Math.abs(v4)
    const s1 = s + (dt * (v + 2 * (v2 + v3) + v4)) / 6
    const v1 = v + (dt * (a1 + 2 * (a2 + a3) + a4)) / 6
    s = s1
    v = v1
  }
  return { s, v, heat: 0 }
}

/** Yoshida’s three Verlet steps. */
export function yoshida4(given: Given, dt: number, steps: number): End {
  const { gravity, k, position, speed } = air(given)
  let s = position
  let v = speed
  for (let n = 0; n < steps; n++) {
    const h1 = OUTER * dt
    const a0 = gravity - k * v * Math.abs(v)
    const sA = s + (v + 0.5 * a0 * h1) * h1
    const a1Speed = v + a0 * h1
    const a1 = gravity - k * a1Speed * Math.abs(a1Speed)
    const vA = v + 0.5 * (a0 + a1) * h1
    const h2 = INNER * dt
    const b1 = gravity - k * vA * Math.abs(vA)
    const sB = sA + (vA + 0.5 * b1 * h2) * h2
    const a2Speed = vA + b1 * h2
    const a2 = gravity - k * a2Speed * Math.abs(a2Speed)
    const vB = vA + 0.5 * (b1 + a2) * h2
    const h3 = OUTER * dt
    const b2 = gravity - k * vB * Math.abs(vB)
    const s1 = sB + (vB + 0.5 * b2 * h3) * h3
    const a3Speed = vB + b2 * h3
    const a3 = gravity - k * a3Speed * Math.abs(a3Speed)
    const v1 = vB + 0.5 * (b2 + a3) * h3
    s = s1
    v = v1
  }
  return { s, v, heat: 0 }
}

/** The implicit midpoint rule. */
export function implicitMidpoint(given: Given, dt: number, steps: number): End {
  const { gravity, k, position, speed } = air(given)
  let s = position
  let v = speed
  for (let n = 0; n < steps; n++) {
    let guess = v
    const a = gravity - k * guess * Math.abs(guess)
    let miss = 0.5 * dt * a
    let change = miss
    for (let i = 1; Math.abs(change) > ROUNDING * (Math.abs(guess) + Math.abs(v)) && i < 40; i++) {
      guess += change
      const aNext = gravity - k * guess * Math.abs(guess)
      const next = v - guess + 0.5 * dt * aNext
      if (next === miss) break
      change *= next / (miss - next)
      miss = next
    }
    const s1 = s + guess * dt
    const v1 = guess + guess - v
    s = s1
    v = v1
  }
  return { s, v, heat: 0 }
}
