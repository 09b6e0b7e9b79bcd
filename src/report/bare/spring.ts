import { INNER, OUTER, ROUNDING } from './constants.ts'
import type { End, Given } from './bareLoop.ts'
import { direction } from './direction.ts'
import { Search } from './search.ts'

/** The scene’s constants: per mass, but for `rubbing`, the force of kinetic friction. */
function springOf({ angle, stiffness, muStatic, muKinetic, gravity, mass, ...start }: Given) {
  const alpha = (angle! * Math.PI) / 180
  const press = gravity! * Math.cos(alpha)
  return {
    weight: gravity! * Math.sin(alpha),
    k: stiffness! / mass!,
    hold: Math.max(muStatic!, muKinetic!) * press,
    friction: muKinetic! * press,
    rubbing: mass! * muKinetic! * press,
    position: start.position!,
    speed: start.speed!,
  }
}

/** Explicit Euler. */
export function explicitEuler(given: Given, dt: number, steps: number): End {
  const { weight, k, hold, friction, rubbing, position, speed } = springOf(given)
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, weight - k * s, hold)

  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const a = weight - k * s - slip * friction
    const s1 = s + v * h
    const v1 = v + a * h
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = 0
      slip = direction(v, weight - k * s, hold)

      left -= h
      h = left
    } else {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1

      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** Semi-implicit Euler. */
export function semiImplicitEuler(given: Given, dt: number, steps: number): End {
  const { weight, k, hold, friction, rubbing, position, speed } = springOf(given)
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, weight - k * s, hold)

  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const a = weight - k * s - slip * friction
    const v1 = v + a * h
    const s1 = s + v1 * h
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = 0
      slip = direction(v, weight - k * s, hold)

      left -= h
      h = left
    } else {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1

      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** Velocity Verlet. */
export function velocityVerlet(given: Given, dt: number, steps: number): End {
  const { weight, k, hold, friction, rubbing, position, speed } = springOf(given)
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, weight - k * s, hold)
  let a = weight - k * s - slip * friction
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const s1 = s + (v + 0.5 * a * h) * h
    const a1 = weight - k * s1 - slip * friction
    const v1 = v + 0.5 * (a + a1) * h
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = 0
      slip = direction(v, weight - k * s, hold)
      a = weight - k * s - slip * friction
      left -= h
      h = left
    } else {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      a = a1
      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** The midpoint method. */
export function midpoint(given: Given, dt: number, steps: number): End {
  const { weight, k, hold, friction, rubbing, position, speed } = springOf(given)
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, weight - k * s, hold)

  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const a = weight - k * s - slip * friction
    const vHalf = v + 0.5 * h * a
    const aHalf = weight - k * (s + 0.5 * h * v) - slip * friction
    const s1 = s + vHalf * h
    const v1 = v + aHalf * h
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = 0
      slip = direction(v, weight - k * s, hold)

      left -= h
      h = left
    } else {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1

      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** The classical Runge–Kutta method. */
export function rk4(given: Given, dt: number, steps: number): End {
  const { weight, k, hold, friction, rubbing, position, speed } = springOf(given)
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, weight - k * s, hold)

  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const a1 = weight - k * s - slip * friction
    const v2 = v + 0.5 * h * a1
    const a2 = weight - k * (s + 0.5 * h * v) - slip * friction
    const v3 = v + 0.5 * h * a2
    const a3 = weight - k * (s + 0.5 * h * v2) - slip * friction
    const v4 = v + h * a3
    const a4 = weight - k * (s + h * v3) - slip * friction
    const s1 = s + (h * (v + 2 * (v2 + v3) + v4)) / 6
    const v1 = v + (h * (a1 + 2 * (a2 + a3) + a4)) / 6
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = 0
      slip = direction(v, weight - k * s, hold)

      left -= h
      h = left
    } else {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1

      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** Yoshida’s three Verlet steps. */
export function yoshida4(given: Given, dt: number, steps: number): End {
  const { weight, k, hold, friction, rubbing, position, speed } = springOf(given)
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, weight - k * s, hold)
  let a = weight - k * s - slip * friction
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const h1 = OUTER * h
    const sA = s + (v + 0.5 * a * h1) * h1
    const a1 = weight - k * sA - slip * friction
    const vA = v + 0.5 * (a + a1) * h1
    const h2 = INNER * h
    const sB = sA + (vA + 0.5 * a1 * h2) * h2
    const a2 = weight - k * sB - slip * friction
    const vB = vA + 0.5 * (a1 + a2) * h2
    const h3 = OUTER * h
    const s1 = sB + (vB + 0.5 * a2 * h3) * h3
    const a3 = weight - k * s1 - slip * friction
    const v1 = vB + 0.5 * (a2 + a3) * h3
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = 0
      slip = direction(v, weight - k * s, hold)
      a = weight - k * s - slip * friction
      left -= h
      h = left
    } else {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1
      a = a3
      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** The implicit midpoint rule. */
export function implicitMidpoint(given: Given, dt: number, steps: number): End {
  const { weight, k, hold, friction, rubbing, position, speed } = springOf(given)
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let slip = direction(v, weight - k * s, hold)

  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    let guess = v
    const a = weight - k * (s + 0.5 * h * guess) - slip * friction
    let miss = 0.5 * h * a
    let change = miss
    for (let i = 1; Math.abs(change) > ROUNDING * (Math.abs(guess) + Math.abs(v)) && i < 40; i++) {
      guess += change
      const aNext = weight - k * (s + 0.5 * h * guess) - slip * friction
      const next = v - guess + 0.5 * h * aNext
      if (next === miss) break
      change *= next / (miss - next)
      miss = next
    }
    const s1 = s + guess * h
    const v1 = guess + guess - v
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = 0
      slip = direction(v, weight - k * s, hold)

      left -= h
      h = left
    } else {
      heat += rubbing * Math.abs(s1 - s)
      s = s1
      v = v1

      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}
