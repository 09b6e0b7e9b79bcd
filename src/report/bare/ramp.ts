import { INNER, OUTER, ROUNDING } from './constants.ts'
import type { End, Given } from './bareLoop.ts'
import { direction } from './direction.ts'

/** The scene’s constants: per mass, but for `rubbing`, the force of kinetic friction. */
function slope({ angle, muStatic, muKinetic, gravity, mass, position, speed }: Given) {
  const alpha = (angle! * Math.PI) / 180
  const press = gravity! * Math.cos(alpha)
  return {
    drive: gravity! * Math.sin(alpha),
    hold: Math.max(muStatic!, muKinetic!) * press,
    friction: muKinetic! * press,
    rubbing: mass! * muKinetic! * press,
    position: position!,
    speed: speed!,
  }
}

/** Explicit Euler. */
export function explicitEuler(given: Given, dt: number, steps: number): End {
  const { drive, hold, friction, rubbing, position, speed } = slope(given)
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, drive, hold)
  let a = drive - slip * friction
  let left = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const s1 = s + v * left
    const v1 = v + a * left
    if (slip > 0 ? v1 >= 0 : v1 <= 0) {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      left = dt
      n++
    } else {
      const stop = -v / a
      const there = s + v * stop
      heat += rubbing * Math.abs(there - s)
      s = there
      v = 0
      left -= stop
      slip = direction(v, drive, hold)
      a = drive - slip * friction
    }
  }
  return { s, v, heat }
}

/** Semi-implicit Euler. */
export function semiImplicitEuler(given: Given, dt: number, steps: number): End {
  const { drive, hold, friction, rubbing, position, speed } = slope(given)
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, drive, hold)
  let a = drive - slip * friction
  let left = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const v1 = v + a * left
    const s1 = s + v1 * left
    if (slip > 0 ? v1 >= 0 : v1 <= 0) {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      left = dt
      n++
    } else {
      const stop = -v / a
      const there = s
      heat += rubbing * Math.abs(there - s)
      s = there
      v = 0
      left -= stop
      slip = direction(v, drive, hold)
      a = drive - slip * friction
    }
  }
  return { s, v, heat }
}

/** Velocity Verlet. */
export function velocityVerlet(given: Given, dt: number, steps: number): End {
  const { drive, hold, friction, rubbing, position, speed } = slope(given)
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, drive, hold)
  let a = drive - slip * friction
  let left = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const s1 = s + (v + 0.5 * a * left) * left
    const v1 = v + 0.5 * (a + a) * left
    if (slip > 0 ? v1 >= 0 : v1 <= 0) {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      left = dt
      n++
    } else {
      const stop = -v / a
      const there = s + 0.5 * v * stop
      heat += rubbing * Math.abs(there - s)
      s = there
      v = 0
      left -= stop
      slip = direction(v, drive, hold)
      a = drive - slip * friction
    }
  }
  return { s, v, heat }
}

/** The midpoint method. */
export function midpoint(given: Given, dt: number, steps: number): End {
  const { drive, hold, friction, rubbing, position, speed } = slope(given)
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, drive, hold)
  let a = drive - slip * friction
  let left = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const vHalf = v + 0.5 * left * a
    const s1 = s + vHalf * left
    const v1 = v + a * left
    if (slip > 0 ? v1 >= 0 : v1 <= 0) {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      left = dt
      n++
    } else {
      const stop = -v / a
      const there = s + 0.5 * v * stop
      heat += rubbing * Math.abs(there - s)
      s = there
      v = 0
      left -= stop
      slip = direction(v, drive, hold)
      a = drive - slip * friction
    }
  }
  return { s, v, heat }
}

/** The classical Runge–Kutta method. */
export function rk4(given: Given, dt: number, steps: number): End {
  const { drive, hold, friction, rubbing, position, speed } = slope(given)
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, drive, hold)
  let a = drive - slip * friction
  let left = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const v2 = v + 0.5 * left * a
    const v3 = v + 0.5 * left * a
    const v4 = v + left * a
    const s1 = s + (left * (v + 2 * (v2 + v3) + v4)) / 6
    const v1 = v + (left * (a + 2 * (a + a) + a)) / 6
    if (slip > 0 ? v1 >= 0 : v1 <= 0) {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      left = dt
      n++
    } else {
      const stop = -v / a
      const there = s + 0.5 * v * stop
      heat += rubbing * Math.abs(there - s)
      s = there
      v = 0
      left -= stop
      slip = direction(v, drive, hold)
      a = drive - slip * friction
    }
  }
  return { s, v, heat }
}

/** Yoshida’s three Verlet steps. */
export function yoshida4(given: Given, dt: number, steps: number): End {
  const { drive, hold, friction, rubbing, position, speed } = slope(given)
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, drive, hold)
  let a = drive - slip * friction
  let left = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const h1 = OUTER * left
    const sA = s + (v + 0.5 * a * h1) * h1
    const vA = v + 0.5 * (a + a) * h1
    const h2 = INNER * left
    const sB = sA + (vA + 0.5 * a * h2) * h2
    const vB = vA + 0.5 * (a + a) * h2
    const h3 = OUTER * left
    const s1 = sB + (vB + 0.5 * a * h3) * h3
    const v1 = vB + 0.5 * (a + a) * h3
    if (slip > 0 ? v1 >= 0 : v1 <= 0) {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      left = dt
      n++
    } else {
      const stop = -v / a
      const there = s + 0.5 * v * stop
      heat += rubbing * Math.abs(there - s)
      s = there
      v = 0
      left -= stop
      slip = direction(v, drive, hold)
      a = drive - slip * friction
    }
  }
  return { s, v, heat }
}

/** The implicit midpoint rule. */
export function implicitMidpoint(given: Given, dt: number, steps: number): End {
  const { drive, hold, friction, rubbing, position, speed } = slope(given)
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, drive, hold)
  let a = drive - slip * friction
  let left = dt
  for (let n = 0; n < steps && slip !== 0;) {
    let guess = v
    let miss = 0.5 * left * a
    let change = miss
    for (let i = 1; Math.abs(change) > ROUNDING * (Math.abs(guess) + Math.abs(v)) && i < 40; i++) {
      guess += change
      const next = v - guess + 0.5 * left * a
      if (next === miss) break
      change *= next / (miss - next)
      miss = next
    }
    const s1 = s + guess * left
    const v1 = guess + guess - v
    if (slip > 0 ? v1 >= 0 : v1 <= 0) {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      left = dt
      n++
    } else {
      const stop = -v / a
      const there = s + 0.5 * v * stop
      heat += rubbing * Math.abs(there - s)
      s = there
      v = 0
      left -= stop
      slip = direction(v, drive, hold)
      a = drive - slip * friction
    }
  }
  return { s, v, heat }
}
