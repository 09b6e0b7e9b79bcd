interface Vector {
  x: number
  y: number
  z: number
}

const dot = (a: Vector, b: Vector) => a.x * b.x + a.y * b.y + a.z * b.z
const length = (a: Vector) => Math.sqrt(dot(a, a))
const add = (a: Vector, b: Vector, c: number): Vector => {
  return { x: a.x + b.x * c, y: a.y + b.y * c, z: a.z + b.z * c }
}

/** Moves a body that slides on a surface by dt seconds. */
export function step(
  body: { position: Vector; velocity: Vector },
  dt: number,
  gravity: Vector,
  normal: Vector,
  muStatic: number,
  muKinetic: number,
): void {
  // 1. Gravity drives along the surface and presses into it.
  const drive = add(gravity, normal, -dot(gravity, normal))
  const press = Math.max(0, -dot(gravity, normal))
  const hold = Math.max(muStatic, muKinetic) * press
  let { position } = body
  let velocity = add(body.velocity, normal, -dot(body.velocity, normal))
  let left = dt
  while (left > 0) {
    // 2. At rest, static friction decides: stay, or set off.
    const speed = length(velocity)
    if (speed === 0 && length(drive) <= hold) break
    // 3. Sliding, friction pulls against the way it slides.
    const way = speed > 0 ? velocity : drive
    let a = add(drive, way, (-muKinetic * press) / length(way))
    // 4. If it stops within this part of the step, go only to that instant.
    let t = Math.min(left, Math.max(dt / 1000, (0.02 * speed) / length(a)))
    const brake = -dot(a, way) / length(way)
    const stops = brake > 0 && speed / brake <= t
    if (stops) t = speed / brake
    // 5. The way turns: what it is halfway is right for the whole part.
    const halfway = stops ? way : add(way, a, t / 2)
    a = add(drive, halfway, (-muKinetic * press) / length(halfway))
    position = add(add(position, velocity, t), a, (t * t) / 2)
    velocity = stops ? { x: 0, y: 0, z: 0 } : add(velocity, a, t)
    // 6. Go on with what is left of the step.
    left -= t
  }
  body.position = position
  body.velocity = velocity
}
