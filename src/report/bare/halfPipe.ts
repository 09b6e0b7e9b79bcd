import { INNER, OUTER, ROUNDING } from './constants.ts'
import type { End, Given } from './bareLoop.ts'
import { direction } from './direction.ts'
import { Search } from './search.ts'

/** The scene’s constants. A block that leaves the pipe is lost: the loops end there. */
function pipe({ radius, gravity, muStatic, muKinetic, mass, position, speed }: Given) {
  return {
    radius: radius!,
    gravity: gravity!,
    mu: Math.max(muStatic!, muKinetic!),
    muKinetic: muKinetic!,
    mass: mass!,
    position: position!,
    speed: speed!,
  }
}

/** Explicit Euler. */
export function explicitEuler(given: Given, dt: number, steps: number): End {
  const { radius, gravity, mu, muKinetic, mass, position, speed } = pipe(given)
  const lip = (Math.PI / 2) * radius
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let sin = Math.sin(s / radius)
  let cos = Math.cos(s / radius)
  let slip = direction(v, -gravity * sin, mu * gravity * cos)
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const aPress = gravity * cos + (v * v) / radius
    const a = -gravity * sin - slip * muKinetic * aPress
    const s1 = s + v * h
    const v1 = v + a * h
    const angle1 = s1 / radius
    const sin1 = Math.sin(angle1)
    const cos1 = Math.cos(angle1)
    const work = 0.5 * (aPress + gravity * cos1 + (v1 * v1) / radius) * (s1 - s)
    if (Math.abs(s1) > lip) break
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = 0
      sin = sin1
      cos = cos1
      slip = direction(v, -gravity * sin, mu * gravity * cos)
      left -= h
      h = left
    } else {
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = v1
      sin = sin1
      cos = cos1
      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** Semi-implicit Euler. */
export function semiImplicitEuler(given: Given, dt: number, steps: number): End {
  const { radius, gravity, mu, muKinetic, mass, position, speed } = pipe(given)
  const lip = (Math.PI / 2) * radius
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let sin = Math.sin(s / radius)
  let cos = Math.cos(s / radius)
  let slip = direction(v, -gravity * sin, mu * gravity * cos)
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const aPress = gravity * cos + (v * v) / radius
    const a = -gravity * sin - slip * muKinetic * aPress
    const v1 = v + a * h
    const s1 = s + v1 * h
    const angle1 = s1 / radius
    const sin1 = Math.sin(angle1)
    const cos1 = Math.cos(angle1)
    const work = 0.5 * (aPress + gravity * cos1 + (v1 * v1) / radius) * (s1 - s)
    if (Math.abs(s1) > lip) break
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = 0
      sin = sin1
      cos = cos1
      slip = direction(v, -gravity * sin, mu * gravity * cos)
      left -= h
      h = left
    } else {
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = v1
      sin = sin1
      cos = cos1
      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** Velocity Verlet. */
export function velocityVerlet(given: Given, dt: number, steps: number): End {
  const { radius, gravity, mu, muKinetic, mass, position, speed } = pipe(given)
  const lip = (Math.PI / 2) * radius
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let sin = Math.sin(s / radius)
  let cos = Math.cos(s / radius)
  let slip = direction(v, -gravity * sin, mu * gravity * cos)
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const aPress = gravity * cos + (v * v) / radius
    const a = -gravity * sin - slip * muKinetic * aPress
    const s1 = s + (v + 0.5 * a * h) * h
    const angle1 = s1 / radius
    const sin1 = Math.sin(angle1)
    const cos1 = Math.cos(angle1)
    const a1Speed = v + a * h
    const a1Press = gravity * cos1 + (a1Speed * a1Speed) / radius
    const a1 = -gravity * sin1 - slip * muKinetic * a1Press
    const v1 = v + 0.5 * (a + a1) * h
    const work = 0.5 * (aPress + gravity * cos1 + (v1 * v1) / radius) * (s1 - s)
    if (Math.abs(s1) > lip) break
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = 0
      sin = sin1
      cos = cos1
      slip = direction(v, -gravity * sin, mu * gravity * cos)
      left -= h
      h = left
    } else {
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = v1
      sin = sin1
      cos = cos1
      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** The midpoint method. */
export function midpoint(given: Given, dt: number, steps: number): End {
  const { radius, gravity, mu, muKinetic, mass, position, speed } = pipe(given)
  const lip = (Math.PI / 2) * radius
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let sin = Math.sin(s / radius)
  let cos = Math.cos(s / radius)
  let slip = direction(v, -gravity * sin, mu * gravity * cos)
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const aPress = gravity * cos + (v * v) / radius
    const a = -gravity * sin - slip * muKinetic * aPress
    const vHalf = v + 0.5 * h * a
    const angleHalf = (s + 0.5 * h * v) / radius
    const sinHalf = Math.sin(angleHalf)
    const cosHalf = Math.cos(angleHalf)
    const aHalfPress = gravity * cosHalf + (vHalf * vHalf) / radius
    const aHalf = -gravity * sinHalf - slip * muKinetic * aHalfPress
    const s1 = s + vHalf * h
    const v1 = v + aHalf * h
    const angle1 = s1 / radius
    const sin1 = Math.sin(angle1)
    const cos1 = Math.cos(angle1)
    const work = 0.5 * (aPress + gravity * cos1 + (v1 * v1) / radius) * (s1 - s)
    if (Math.abs(s1) > lip) break
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = 0
      sin = sin1
      cos = cos1
      slip = direction(v, -gravity * sin, mu * gravity * cos)
      left -= h
      h = left
    } else {
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = v1
      sin = sin1
      cos = cos1
      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** The classical Runge–Kutta method. */
export function rk4(given: Given, dt: number, steps: number): End {
  const { radius, gravity, mu, muKinetic, mass, position, speed } = pipe(given)
  const lip = (Math.PI / 2) * radius
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0

  let slip = direction(v, -gravity * Math.sin(s / radius), mu * gravity * Math.cos(s / radius))
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const angle1 = s / radius
    const sin1 = Math.sin(angle1)
    const cos1 = Math.cos(angle1)
    const a1Press = gravity * cos1 + (v * v) / radius
    const a1 = -gravity * sin1 - slip * muKinetic * a1Press
    const v2 = v + 0.5 * h * a1
    const angle2 = (s + 0.5 * h * v) / radius
    const sin2 = Math.sin(angle2)
    const cos2 = Math.cos(angle2)
    const a2Press = gravity * cos2 + (v2 * v2) / radius
    const a2 = -gravity * sin2 - slip * muKinetic * a2Press
    const v3 = v + 0.5 * h * a2
    const angle3 = (s + 0.5 * h * v2) / radius
    const sin3 = Math.sin(angle3)
    const cos3 = Math.cos(angle3)
    const a3Press = gravity * cos3 + (v3 * v3) / radius
    const a3 = -gravity * sin3 - slip * muKinetic * a3Press
    const v4 = v + h * a3
    const angle4 = (s + h * v3) / radius
    const sin4 = Math.sin(angle4)
    const cos4 = Math.cos(angle4)
    const a4Press = gravity * cos4 + (v4 * v4) / radius
    const a4 = -gravity * sin4 - slip * muKinetic * a4Press
    const s1 = s + (h * (v + 2 * (v2 + v3) + v4)) / 6
    const v1 = v + (h * (a1 + 2 * (a2 + a3) + a4)) / 6
    const work = (h * (a1Press * v + 2 * (a2Press * v2 + a3Press * v3) + a4Press * v4)) / 6
    if (Math.abs(s1) > lip) break
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = 0

      slip = direction(v, -gravity * Math.sin(s / radius), mu * gravity * Math.cos(s / radius))
      left -= h
      h = left
    } else {
      heat += mass * muKinetic * Math.abs(work)
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
  const { radius, gravity, mu, muKinetic, mass, position, speed } = pipe(given)
  const lip = (Math.PI / 2) * radius
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0
  let sin = Math.sin(s / radius)
  let cos = Math.cos(s / radius)
  let slip = direction(v, -gravity * sin, mu * gravity * cos)
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    const h1 = OUTER * h
    const a0Press = gravity * cos + (v * v) / radius
    const a0 = -gravity * sin - slip * muKinetic * a0Press
    const sA = s + (v + 0.5 * a0 * h1) * h1
    const angleA = sA / radius
    const sinA = Math.sin(angleA)
    const cosA = Math.cos(angleA)
    const a1Speed = v + a0 * h1
    const a1Press = gravity * cosA + (a1Speed * a1Speed) / radius
    const a1 = -gravity * sinA - slip * muKinetic * a1Press
    const vA = v + 0.5 * (a0 + a1) * h1
    const h2 = INNER * h
    const b1Press = gravity * cosA + (vA * vA) / radius
    const b1 = -gravity * sinA - slip * muKinetic * b1Press
    const sB = sA + (vA + 0.5 * b1 * h2) * h2
    const angleB = sB / radius
    const sinB = Math.sin(angleB)
    const cosB = Math.cos(angleB)
    const a2Speed = vA + b1 * h2
    const a2Press = gravity * cosB + (a2Speed * a2Speed) / radius
    const a2 = -gravity * sinB - slip * muKinetic * a2Press
    const vB = vA + 0.5 * (b1 + a2) * h2
    const h3 = OUTER * h
    const b2Press = gravity * cosB + (vB * vB) / radius
    const b2 = -gravity * sinB - slip * muKinetic * b2Press
    const s1 = sB + (vB + 0.5 * b2 * h3) * h3
    const angle1 = s1 / radius
    const sin1 = Math.sin(angle1)
    const cos1 = Math.cos(angle1)
    const a3Speed = vB + b2 * h3
    const a3Press = gravity * cos1 + (a3Speed * a3Speed) / radius
    const a3 = -gravity * sin1 - slip * muKinetic * a3Press
    const v1 = vB + 0.5 * (b2 + a3) * h3
    const endPress = gravity * cos1 + (v1 * v1) / radius
    const work =
      0.5 *
      (h1 * (a0Press * v + b1Press * vA) +
        h2 * (b1Press * vA + b2Press * vB) +
        h3 * (b2Press * vB + endPress * v1))
    if (Math.abs(s1) > lip) break
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = 0
      sin = sin1
      cos = cos1
      slip = direction(v, -gravity * sin, mu * gravity * cos)
      left -= h
      h = left
    } else {
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = v1
      sin = sin1
      cos = cos1
      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}

/** The implicit midpoint rule. */
export function implicitMidpoint(given: Given, dt: number, steps: number): End {
  const { radius, gravity, mu, muKinetic, mass, position, speed } = pipe(given)
  const lip = (Math.PI / 2) * radius
  const stop = new Search()
  let s = position
  let v = speed
  let heat = 0

  let slip = direction(v, -gravity * Math.sin(s / radius), mu * gravity * Math.cos(s / radius))
  let left = dt
  let h = dt
  for (let n = 0; n < steps && slip !== 0;) {
    let cosMean = 1
    let guess = v
    const angle0 = (s + 0.5 * h * guess) / radius
    const sin0 = Math.sin(angle0)
    const cos0 = Math.cos(angle0)
    cosMean = cos0
    const aPress = gravity * cos0 + (guess * guess) / radius
    const a = -gravity * sin0 - slip * muKinetic * aPress
    let miss = 0.5 * h * a
    let change = miss
    for (let i = 1; Math.abs(change) > ROUNDING * (Math.abs(guess) + Math.abs(v)) && i < 40; i++) {
      guess += change
      const angleNext = (s + 0.5 * h * guess) / radius
      const sinNext = Math.sin(angleNext)
      const cosNext = Math.cos(angleNext)
      cosMean = cosNext
      const aNextPress = gravity * cosNext + (guess * guess) / radius
      const aNext = -gravity * sinNext - slip * muKinetic * aNextPress
      const next = v - guess + 0.5 * h * aNext
      if (next === miss) break
      change *= next / (miss - next)
      miss = next
    }
    const s1 = s + guess * h
    const v1 = guess + guess - v
    const work = (gravity * cosMean + (guess * guess) / radius) * (s1 - s)
    if (Math.abs(s1) > lip) break
    if (stop.searching || slip * v1 < 0) {
      h = stop.next(h, slip * v, slip * v1)
      if (stop.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = 0

      slip = direction(v, -gravity * Math.sin(s / radius), mu * gravity * Math.cos(s / radius))
      left -= h
      h = left
    } else {
      heat += mass * muKinetic * Math.abs(work)
      s = s1
      v = v1

      left = dt
      h = dt
      n++
    }
  }
  return { s, v, heat }
}
