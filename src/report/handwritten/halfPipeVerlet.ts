import { HandwrittenClock, slipDirection } from './block.ts'
import type { HandwrittenBlock, Given } from './block.ts'
import { locate } from './locate.ts'

/** The half-pipe by velocity Verlet, which keeps the direction at the end of a step for the next. */
export class HalfPipeVerlet implements HandwrittenBlock {
  s = NaN
  v = NaN
  heat = NaN
  slip: -1 | 0 | 1 = 0
  readonly clock = new HandwrittenClock()
  private sin = NaN
  private cos = NaN
  // Where a tried step ends, and its heat for a unit of mass and friction.
  private s1 = NaN
  private v1 = NaN
  private sin1 = NaN
  private cos1 = NaN
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
    this.sin = Math.sin(this.s / this.radius)
    this.cos = Math.cos(this.s / this.radius)
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
      this.sin = this.sin1
      this.cos = this.cos1
      left -= h
      if (leaves) this.slip = 0
      else if (stops) this.chooseSlip()
    }
  }

  tryStep(h: number): void {
    const { s, v, sin, cos, radius, gravity } = this
    const friction = this.slip * this.muKinetic
    const normal = gravity * cos + (v * v) / radius
    const a = -gravity * sin - friction * normal
    const s1 = s + (v + 0.5 * a * h) * h
    const sin1 = Math.sin(s1 / radius)
    const cos1 = Math.cos(s1 / radius)
    const guess = v + a * h
    const a1 = -gravity * sin1 - friction * (gravity * cos1 + (guess * guess) / radius)
    const v1 = v + 0.5 * (a + a1) * h
    this.s1 = s1
    this.v1 = v1
    this.sin1 = sin1
    this.cos1 = cos1
    this.work = 0.5 * (normal + gravity * cos1 + (v1 * v1) / radius) * (s1 - s)
  }

  private locateStop(h: number): number {
    return locate(this, h, () => this.slip * this.v1)
  }

  private locateLip(h: number): number {
    return locate(this, h, () => this.lip - Math.abs(this.s1))
  }

  private chooseSlip(): void {
    const { gravity, muStatic } = this
    this.slip = slipDirection(this.v, -gravity * this.sin, muStatic * gravity * this.cos)
  }
}
