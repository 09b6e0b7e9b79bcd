import { HandwrittenClock, slipDirection } from './block.ts'
import type { HandwrittenBlock, Given } from './block.ts'
import { locate } from './locate.ts'

/** The half-pipe by the classical Runge–Kutta method, which adds up the heat with the same weights. */
export class HalfPipeRk4 implements HandwrittenBlock {
  s = NaN
  v = NaN
  heat = NaN
  slip: -1 | 0 | 1 = 0
  readonly clock = new HandwrittenClock()
  // Where a tried step ends, and its heat for a unit of mass and friction.
  private s1 = NaN
  private v1 = NaN
  private work = NaN
  private readonly radius: number
  private readonly lip: number
  private readonly gravity: number
  private readonly muStatic: number
  private readonly muKinetic: number
  private readonly mass: number

  constructor({ radius, muStatic, muKinetic, gravity, mass, position, speed }: Given) {
    this.radius = radius!
    this.lip = (Math.PI / 2) * radius!
    this.gravity = gravity!
    this.muStatic = muStatic!
    this.muKinetic = muKinetic!
    this.mass = mass!
    this.s = position!
    this.v = speed!
    this.heat = 0
    this.chooseSlip()
  }

  frames(count: number, dt: number): void {
    for (let n = 0; n < count; n++) this.frame(dt)
  }

  private frame(dt: number): void {
    this.clock.add(dt)
    let left = dt
    while (left > 0 && this.slip !== 0) {
      let h = left
      this.tryStep(h)
      const stops = this.slip * this.v1 < 0
      if (stops) h = this.locateStop(h)
      const leaves = !(Math.abs(this.s1) < this.lip)
      if (leaves) h = this.locateLip(h)
      this.heat += this.mass * this.muKinetic * Math.abs(this.work)
      this.s = this.s1
      this.v = stops && !leaves ? 0 : this.v1
      left -= h
      if (leaves) this.slip = 0
      else if (stops) this.chooseSlip()
    }
  }

  tryStep(h: number): void {
    const { s, v, radius, gravity } = this
    const friction = this.slip * this.muKinetic
    const angle1 = s / radius
    const normal1 = gravity * Math.cos(angle1) + (v * v) / radius
    const a1 = -gravity * Math.sin(angle1) - friction * normal1
    const v2 = v + 0.5 * h * a1
    const angle2 = (s + 0.5 * h * v) / radius
    const normal2 = gravity * Math.cos(angle2) + (v2 * v2) / radius
    const a2 = -gravity * Math.sin(angle2) - friction * normal2
    const v3 = v + 0.5 * h * a2
    const angle3 = (s + 0.5 * h * v2) / radius
    const normal3 = gravity * Math.cos(angle3) + (v3 * v3) / radius
    const a3 = -gravity * Math.sin(angle3) - friction * normal3
    const v4 = v + h * a3
    const angle4 = (s + h * v3) / radius
    const normal4 = gravity * Math.cos(angle4) + (v4 * v4) / radius
    const a4 = -gravity * Math.sin(angle4) - friction * normal4
    this.s1 = s + (h * (v + 2 * (v2 + v3) + v4)) / 6
    this.v1 = v + (h * (a1 + 2 * (a2 + a3) + a4)) / 6
    this.work = (h * (normal1 * v + 2 * (normal2 * v2 + normal3 * v3) + normal4 * v4)) / 6
  }

  private locateStop(h: number): number {
    return locate(this, h, () => this.slip * this.v1)
  }

  private locateLip(h: number): number {
    return locate(this, h, () => this.lip - Math.abs(this.s1))
  }

  private chooseSlip(): void {
    const { gravity, muStatic, radius, s, v } = this
    const angle = s / radius
    this.slip = slipDirection(v, -gravity * Math.sin(angle), muStatic * gravity * Math.cos(angle))
  }
}
