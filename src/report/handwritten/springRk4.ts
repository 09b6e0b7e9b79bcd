import { HandwrittenClock, FAR, slipDirection } from './block.ts'
import type { HandwrittenBlock, Given } from './block.ts'
import { locate } from './locate.ts'

/** The spring by the classical Runge–Kutta method. */
export class SpringRk4 implements HandwrittenBlock {
  s = NaN
  v = NaN
  heat = NaN
  slip: -1 | 0 | 1 = 0
  readonly clock = new HandwrittenClock()
  // Where a tried step ends.
  private s1 = NaN
  private v1 = NaN
  private readonly tangential: number
  private readonly perMetre: number
  private readonly hold: number
  private readonly friction: number
  private readonly mass: number

  constructor({ angle, stiffness, muStatic, muKinetic, gravity, mass, ...start }: Given) {
    const alpha = (angle! * Math.PI) / 180
    const normal = gravity! * Math.cos(alpha)
    this.tangential = gravity! * Math.sin(alpha)
    this.perMetre = stiffness! / mass!
    this.hold = muStatic! * normal
    this.friction = muKinetic! * normal
    this.mass = mass!
    this.s = start.position!
    this.v = start.speed!
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
      this.heat += this.mass * this.friction * Math.abs(this.s1 - this.s)
      this.s = this.s1
      this.v = stops ? 0 : this.v1
      left -= h
      if (stops) this.chooseSlip()
      if (!(Math.abs(this.s) < FAR)) this.slip = 0
    }
  }

  tryStep(h: number): void {
    const { s, v, perMetre } = this
    const steady = this.tangential - this.slip * this.friction
    const a1 = steady - perMetre * s
    const v2 = v + 0.5 * h * a1
    const a2 = steady - perMetre * (s + 0.5 * h * v)
    const v3 = v + 0.5 * h * a2
    const a3 = steady - perMetre * (s + 0.5 * h * v2)
    const v4 = v + h * a3
    const a4 = steady - perMetre * (s + h * v3)
    this.s1 = s + (h * (v + 2 * (v2 + v3) + v4)) / 6
    this.v1 = v + (h * (a1 + 2 * (a2 + a3) + a4)) / 6
  }

  private locateStop(h: number): number {
    return locate(this, h, () => this.slip * this.v1)
  }

  private chooseSlip(): void {
    this.slip = slipDirection(this.v, this.tangential - this.perMetre * this.s, this.hold)
  }
}
