interface Vector {
  x: number
  y: number
}

const dot = (a: Vector, b: Vector) => a.x * b.x + a.y * b.y

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
  const along = { x: normal.y, y: -normal.x }
  const drive = dot(gravity, along)
  const press = Math.max(0, -dot(gravity, normal))
  const hold = Math.max(muStatic, muKinetic) * press
  const { position, velocity } = body
  let speed = dot(velocity, along)
  let moved = 0
  let left = dt
  while (left > 0) {
    // 2. At rest, static friction decides: stay, or set off.
    if (speed === 0 && Math.abs(drive) <= hold) break
    // 3. Sliding, friction pulls against the way it slides.
    const slip = Math.sign(speed !== 0 ? speed : drive)
    const a = drive - slip * muKinetic * press
    // 4. If it stops within the step, go only to that instant.
    const stops = slip * a < 0 && -speed / a <= left
    const t = stops ? -speed / a : left
    // 5. Along the parabola: exact while the force is constant.
    moved += (speed + 0.5 * a * t) * t
    speed = stops ? 0 : speed + a * t
    // 6. Go on with what is left of the step.
    left -= t
  }
  body.position = { x: position.x + along.x * moved, y: position.y + along.y * moved }
  body.velocity = { x: along.x * speed, y: along.y * speed }
}
