import { INNER, OUTER, ROUNDING } from './constants.ts'
import { direction } from './direction.ts'
import type { End, Given } from './bareLoop.ts'
import { Search } from './search.ts'

/**
 * The scene’s constants. The loops are for a block that starts on the slope, downhill or at rest: nothing drives it back, and
 * where it stops it stays.
 */
function hill({ angle, length, bendRadius, gravity, muStatic, muKinetic, mass, ...start }: Given) {
  const alpha = (angle! * Math.PI) / 180
  return {
    alpha,
    length: length!,
    end: length! + bendRadius! * alpha,
    curvature: 1 / bendRadius!,
    gravity: gravity!,
    mu: Math.max(muStatic!, muKinetic!),
    muKinetic: muKinetic!,
    mass: mass!,
    position: start.position!,
    speed: start.speed!,
  }
}

/** Explicit Euler. */
export function explicitEuler(given: Given, dt: number, steps: number): End {
  const { alpha, length, end, curvature, gravity, mu, muKinetic, mass, position, speed } =
    hill(given)
  const search = new Search()
  let s = position
  let v = speed
  let heat = 0
  if (direction(v, gravity * Math.sin(alpha), mu * gravity * Math.cos(alpha)) === 0)
    return { s, v, heat }
  // The piece of track, where it ends, and what acts on a block on a straight one.
  let piece = 0
  let to = length
  let press = gravity * Math.cos(alpha)
  let a = gravity * Math.sin(alpha) - muKinetic * press
  let sin = Math.sin(alpha)
  let cos = Math.cos(alpha)
  let atJoint = false
  let left = dt
  let h = dt
  for (let n = 0; n < steps;) {
    let s1 = 0
    let v1 = 0
    let work = 0
    if (piece === 1) {
      const aPress = gravity * cos + v * v * curvature
      const a = gravity * sin - muKinetic * aPress
      s1 = s + v * h
      v1 = v + a * h
      const angle1 = alpha - curvature * (s1 - length)
      const sin1 = Math.sin(angle1)
      const cos1 = Math.cos(angle1)
      work = 0.5 * (aPress + gravity * cos1 + v1 * v1 * curvature) * (s1 - s)
      if (!(s1 > to || v1 < 0 || search.searching)) {
        sin = sin1
        cos = cos1
      }
    } else {
      s1 = s + v * h
      v1 = v + a * h
      work = press * (s1 - s)
    }
    if (search.searching || s1 > to || v1 < 0) {
      if (!search.searching) atJoint = s1 > to
      h = atJoint ? search.next(h, to - s, to - s1) : search.next(h, v, v1)
      if (search.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = atJoint ? to : s1
      v = atJoint ? v1 : 0
      if (!atJoint) break
      piece++
      to = piece === 1 ? end : Infinity
      press = gravity
      a = -muKinetic * press
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

/** Semi-implicit Euler. */
export function semiImplicitEuler(given: Given, dt: number, steps: number): End {
  const { alpha, length, end, curvature, gravity, mu, muKinetic, mass, position, speed } =
    hill(given)
  const search = new Search()
  let s = position
  let v = speed
  let heat = 0
  if (direction(v, gravity * Math.sin(alpha), mu * gravity * Math.cos(alpha)) === 0)
    return { s, v, heat }
  // The piece of track, where it ends, and what acts on a block on a straight one.
  let piece = 0
  let to = length
  let press = gravity * Math.cos(alpha)
  let a = gravity * Math.sin(alpha) - muKinetic * press
  let sin = Math.sin(alpha)
  let cos = Math.cos(alpha)
  let atJoint = false
  let left = dt
  let h = dt
  for (let n = 0; n < steps;) {
    let s1 = 0
    let v1 = 0
    let work = 0
    if (piece === 1) {
      const aPress = gravity * cos + v * v * curvature
      const a = gravity * sin - muKinetic * aPress
      v1 = v + a * h
      s1 = s + v1 * h
      const angle1 = alpha - curvature * (s1 - length)
      const sin1 = Math.sin(angle1)
      const cos1 = Math.cos(angle1)
      work = 0.5 * (aPress + gravity * cos1 + v1 * v1 * curvature) * (s1 - s)
      if (!(s1 > to || v1 < 0 || search.searching)) {
        sin = sin1
        cos = cos1
      }
    } else {
      v1 = v + a * h
      s1 = s + v1 * h
      work = press * (s1 - s)
    }
    if (search.searching || s1 > to || v1 < 0) {
      if (!search.searching) atJoint = s1 > to
      h = atJoint ? search.next(h, to - s, to - s1) : search.next(h, v, v1)
      if (search.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = atJoint ? to : s1
      v = atJoint ? v1 : 0
      if (!atJoint) break
      piece++
      to = piece === 1 ? end : Infinity
      press = gravity
      a = -muKinetic * press
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

/** Velocity Verlet. */
export function velocityVerlet(given: Given, dt: number, steps: number): End {
  const { alpha, length, end, curvature, gravity, mu, muKinetic, mass, position, speed } =
    hill(given)
  const search = new Search()
  let s = position
  let v = speed
  let heat = 0
  if (direction(v, gravity * Math.sin(alpha), mu * gravity * Math.cos(alpha)) === 0)
    return { s, v, heat }
  // The piece of track, where it ends, and what acts on a block on a straight one.
  let piece = 0
  let to = length
  let press = gravity * Math.cos(alpha)
  let a = gravity * Math.sin(alpha) - muKinetic * press
  let sin = Math.sin(alpha)
  let cos = Math.cos(alpha)
  let atJoint = false
  let left = dt
  let h = dt
  for (let n = 0; n < steps;) {
    let s1 = 0
    let v1 = 0
    let work = 0
    if (piece === 1) {
      const aPress = gravity * cos + v * v * curvature
      const a = gravity * sin - muKinetic * aPress
      s1 = s + (v + 0.5 * a * h) * h
      const angle1 = alpha - curvature * (s1 - length)
      const sin1 = Math.sin(angle1)
      const cos1 = Math.cos(angle1)
      const a1Speed = v + a * h
      const a1Press = gravity * cos1 + a1Speed * a1Speed * curvature
      const a1 = gravity * sin1 - muKinetic * a1Press
      v1 = v + 0.5 * (a + a1) * h
      work = 0.5 * (aPress + gravity * cos1 + v1 * v1 * curvature) * (s1 - s)
      if (!(s1 > to || v1 < 0 || search.searching)) {
        sin = sin1
        cos = cos1
      }
    } else {
      s1 = s + (v + 0.5 * a * h) * h
      v1 = v + 0.5 * (a + a) * h
      work = press * (s1 - s)
    }
    if (search.searching || s1 > to || v1 < 0) {
      if (!search.searching) atJoint = s1 > to
      h = atJoint ? search.next(h, to - s, to - s1) : search.next(h, v, v1)
      if (search.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = atJoint ? to : s1
      v = atJoint ? v1 : 0
      if (!atJoint) break
      piece++
      to = piece === 1 ? end : Infinity
      press = gravity
      a = -muKinetic * press
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

/** The midpoint method. */
export function midpoint(given: Given, dt: number, steps: number): End {
  const { alpha, length, end, curvature, gravity, mu, muKinetic, mass, position, speed } =
    hill(given)
  const search = new Search()
  let s = position
  let v = speed
  let heat = 0
  if (direction(v, gravity * Math.sin(alpha), mu * gravity * Math.cos(alpha)) === 0)
    return { s, v, heat }
  // The piece of track, where it ends, and what acts on a block on a straight one.
  let piece = 0
  let to = length
  let press = gravity * Math.cos(alpha)
  let a = gravity * Math.sin(alpha) - muKinetic * press
  let sin = Math.sin(alpha)
  let cos = Math.cos(alpha)
  let atJoint = false
  let left = dt
  let h = dt
  for (let n = 0; n < steps;) {
    let s1 = 0
    let v1 = 0
    let work = 0
    if (piece === 1) {
      const aPress = gravity * cos + v * v * curvature
      const a = gravity * sin - muKinetic * aPress
      const vHalf = v + 0.5 * h * a
      const angleHalf = alpha - curvature * (s + 0.5 * h * v - length)
      const sinHalf = Math.sin(angleHalf)
      const cosHalf = Math.cos(angleHalf)
      const aHalfPress = gravity * cosHalf + vHalf * vHalf * curvature
      const aHalf = gravity * sinHalf - muKinetic * aHalfPress
      s1 = s + vHalf * h
      v1 = v + aHalf * h
      const angle1 = alpha - curvature * (s1 - length)
      const sin1 = Math.sin(angle1)
      const cos1 = Math.cos(angle1)
      work = 0.5 * (aPress + gravity * cos1 + v1 * v1 * curvature) * (s1 - s)
      if (!(s1 > to || v1 < 0 || search.searching)) {
        sin = sin1
        cos = cos1
      }
    } else {
      const vHalf = v + 0.5 * h * a
      s1 = s + vHalf * h
      v1 = v + a * h
      work = press * (s1 - s)
    }
    if (search.searching || s1 > to || v1 < 0) {
      if (!search.searching) atJoint = s1 > to
      h = atJoint ? search.next(h, to - s, to - s1) : search.next(h, v, v1)
      if (search.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = atJoint ? to : s1
      v = atJoint ? v1 : 0
      if (!atJoint) break
      piece++
      to = piece === 1 ? end : Infinity
      press = gravity
      a = -muKinetic * press
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

/** The classical Runge–Kutta method. */
export function rk4(given: Given, dt: number, steps: number): End {
  const { alpha, length, end, curvature, gravity, mu, muKinetic, mass, position, speed } =
    hill(given)
  const search = new Search()
  let s = position
  let v = speed
  let heat = 0
  if (direction(v, gravity * Math.sin(alpha), mu * gravity * Math.cos(alpha)) === 0)
    return { s, v, heat }
  // The piece of track, where it ends, and what acts on a block on a straight one.
  let piece = 0
  let to = length
  let press = gravity * Math.cos(alpha)
  let a = gravity * Math.sin(alpha) - muKinetic * press

  let atJoint = false
  let left = dt
  let h = dt
  for (let n = 0; n < steps;) {
    let s1 = 0
    let v1 = 0
    let work = 0
    if (piece === 1) {
      const angle1 = alpha - curvature * (s - length)
      const sin1 = Math.sin(angle1)
      const cos1 = Math.cos(angle1)
      const a1Press = gravity * cos1 + v * v * curvature
      const a1 = gravity * sin1 - muKinetic * a1Press
      const v2 = v + 0.5 * h * a1
      const angle2 = alpha - curvature * (s + 0.5 * h * v - length)
      const sin2 = Math.sin(angle2)
      const cos2 = Math.cos(angle2)
      const a2Press = gravity * cos2 + v2 * v2 * curvature
      const a2 = gravity * sin2 - muKinetic * a2Press
      const v3 = v + 0.5 * h * a2
      const angle3 = alpha - curvature * (s + 0.5 * h * v2 - length)
      const sin3 = Math.sin(angle3)
      const cos3 = Math.cos(angle3)
      const a3Press = gravity * cos3 + v3 * v3 * curvature
      const a3 = gravity * sin3 - muKinetic * a3Press
      const v4 = v + h * a3
      const angle4 = alpha - curvature * (s + h * v3 - length)
      const sin4 = Math.sin(angle4)
      const cos4 = Math.cos(angle4)
      const a4Press = gravity * cos4 + v4 * v4 * curvature
      const a4 = gravity * sin4 - muKinetic * a4Press
      s1 = s + (h * (v + 2 * (v2 + v3) + v4)) / 6
      v1 = v + (h * (a1 + 2 * (a2 + a3) + a4)) / 6
      work = (h * (a1Press * v + 2 * (a2Press * v2 + a3Press * v3) + a4Press * v4)) / 6
      if (!(s1 > to || v1 < 0 || search.searching)) {
      }
    } else {
      const v2 = v + 0.5 * h * a
      const v3 = v + 0.5 * h * a
      const v4 = v + h * a
      s1 = s + (h * (v + 2 * (v2 + v3) + v4)) / 6
      v1 = v + (h * (a + 2 * (a + a) + a)) / 6
      work = press * (s1 - s)
    }
    if (search.searching || s1 > to || v1 < 0) {
      if (!search.searching) atJoint = s1 > to
      h = atJoint ? search.next(h, to - s, to - s1) : search.next(h, v, v1)
      if (search.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = atJoint ? to : s1
      v = atJoint ? v1 : 0
      if (!atJoint) break
      piece++
      to = piece === 1 ? end : Infinity
      press = gravity
      a = -muKinetic * press
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
  const { alpha, length, end, curvature, gravity, mu, muKinetic, mass, position, speed } =
    hill(given)
  const search = new Search()
  let s = position
  let v = speed
  let heat = 0
  if (direction(v, gravity * Math.sin(alpha), mu * gravity * Math.cos(alpha)) === 0)
    return { s, v, heat }
  // The piece of track, where it ends, and what acts on a block on a straight one.
  let piece = 0
  let to = length
  let press = gravity * Math.cos(alpha)
  let a = gravity * Math.sin(alpha) - muKinetic * press
  let sin = Math.sin(alpha)
  let cos = Math.cos(alpha)
  let atJoint = false
  let left = dt
  let h = dt
  for (let n = 0; n < steps;) {
    let s1 = 0
    let v1 = 0
    let work = 0
    if (piece === 1) {
      const h1 = OUTER * h
      const a0Press = gravity * cos + v * v * curvature
      const a0 = gravity * sin - muKinetic * a0Press
      const sA = s + (v + 0.5 * a0 * h1) * h1
      const angleA = alpha - curvature * (sA - length)
      const sinA = Math.sin(angleA)
      const cosA = Math.cos(angleA)
      const a1Speed = v + a0 * h1
      const a1Press = gravity * cosA + a1Speed * a1Speed * curvature
      const a1 = gravity * sinA - muKinetic * a1Press
      const vA = v + 0.5 * (a0 + a1) * h1
      const h2 = INNER * h
      const b1Press = gravity * cosA + vA * vA * curvature
      const b1 = gravity * sinA - muKinetic * b1Press
      const sB = sA + (vA + 0.5 * b1 * h2) * h2
      const angleB = alpha - curvature * (sB - length)
      const sinB = Math.sin(angleB)
      const cosB = Math.cos(angleB)
      const a2Speed = vA + b1 * h2
      const a2Press = gravity * cosB + a2Speed * a2Speed * curvature
      const a2 = gravity * sinB - muKinetic * a2Press
      const vB = vA + 0.5 * (b1 + a2) * h2
      const h3 = OUTER * h
      const b2Press = gravity * cosB + vB * vB * curvature
      const b2 = gravity * sinB - muKinetic * b2Press
      s1 = sB + (vB + 0.5 * b2 * h3) * h3
      const angle1 = alpha - curvature * (s1 - length)
      const sin1 = Math.sin(angle1)
      const cos1 = Math.cos(angle1)
      const a3Speed = vB + b2 * h3
      const a3Press = gravity * cos1 + a3Speed * a3Speed * curvature
      const a3 = gravity * sin1 - muKinetic * a3Press
      v1 = vB + 0.5 * (b2 + a3) * h3
      const endPress = gravity * cos1 + v1 * v1 * curvature
      work =
        0.5 *
        (h1 * (a0Press * v + b1Press * vA) +
          h2 * (b1Press * vA + b2Press * vB) +
          h3 * (b2Press * vB + endPress * v1))
      if (!(s1 > to || v1 < 0 || search.searching)) {
        sin = sin1
        cos = cos1
      }
    } else {
      const h1 = OUTER * h
      const sA = s + (v + 0.5 * a * h1) * h1
      const vA = v + 0.5 * (a + a) * h1
      const h2 = INNER * h
      const sB = sA + (vA + 0.5 * a * h2) * h2
      const vB = vA + 0.5 * (a + a) * h2
      const h3 = OUTER * h
      s1 = sB + (vB + 0.5 * a * h3) * h3
      v1 = vB + 0.5 * (a + a) * h3
      work = press * (s1 - s)
    }
    if (search.searching || s1 > to || v1 < 0) {
      if (!search.searching) atJoint = s1 > to
      h = atJoint ? search.next(h, to - s, to - s1) : search.next(h, v, v1)
      if (search.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = atJoint ? to : s1
      v = atJoint ? v1 : 0
      if (!atJoint) break
      piece++
      to = piece === 1 ? end : Infinity
      press = gravity
      a = -muKinetic * press
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

/** The implicit midpoint rule. */
export function implicitMidpoint(given: Given, dt: number, steps: number): End {
  const { alpha, length, end, curvature, gravity, mu, muKinetic, mass, position, speed } =
    hill(given)
  const search = new Search()
  let s = position
  let v = speed
  let heat = 0
  if (direction(v, gravity * Math.sin(alpha), mu * gravity * Math.cos(alpha)) === 0)
    return { s, v, heat }
  // The piece of track, where it ends, and what acts on a block on a straight one.
  let piece = 0
  let to = length
  let press = gravity * Math.cos(alpha)
  let a = gravity * Math.sin(alpha) - muKinetic * press

  let atJoint = false
  let left = dt
  let h = dt
  for (let n = 0; n < steps;) {
    let s1 = 0
    let v1 = 0
    let work = 0
    if (piece === 1) {
      let cosMean = 1
      let guess = v
      const angle0 = alpha - curvature * (s + 0.5 * h * guess - length)
      const sin0 = Math.sin(angle0)
      const cos0 = Math.cos(angle0)
      cosMean = cos0
      const aPress = gravity * cos0 + guess * guess * curvature
      const a = gravity * sin0 - muKinetic * aPress
      let miss = 0.5 * h * a
      let change = miss
      for (
        let i = 1;
        Math.abs(change) > ROUNDING * (Math.abs(guess) + Math.abs(v)) && i < 40;
        i++
      ) {
        guess += change
        const angleNext = alpha - curvature * (s + 0.5 * h * guess - length)
        const sinNext = Math.sin(angleNext)
        const cosNext = Math.cos(angleNext)
        cosMean = cosNext
        const aNextPress = gravity * cosNext + guess * guess * curvature
        const aNext = gravity * sinNext - muKinetic * aNextPress
        const next = v - guess + 0.5 * h * aNext
        if (next === miss) break
        change *= next / (miss - next)
        miss = next
      }
      s1 = s + guess * h
      v1 = guess + guess - v
      work = (gravity * cosMean + guess * guess * curvature) * (s1 - s)
      if (!(s1 > to || v1 < 0 || search.searching)) {
      }
    } else {
      let guess = v
      let miss = 0.5 * h * a
      let change = miss
      for (
        let i = 1;
        Math.abs(change) > ROUNDING * (Math.abs(guess) + Math.abs(v)) && i < 40;
        i++
      ) {
        guess += change
        const next = v - guess + 0.5 * h * a
        if (next === miss) break
        change *= next / (miss - next)
        miss = next
      }
      s1 = s + guess * h
      v1 = guess + guess - v
      work = press * (s1 - s)
    }
    if (search.searching || s1 > to || v1 < 0) {
      if (!search.searching) atJoint = s1 > to
      h = atJoint ? search.next(h, to - s, to - s1) : search.next(h, v, v1)
      if (search.searching) continue
      heat += mass * muKinetic * Math.abs(work)
      s = atJoint ? to : s1
      v = atJoint ? v1 : 0
      if (!atJoint) break
      piece++
      to = piece === 1 ? end : Infinity
      press = gravity
      a = -muKinetic * press
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
