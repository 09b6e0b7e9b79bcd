import { HandwrittenClock, FAR, slipDirection } from './block.ts'
import type { HandwrittenBlock, Given } from './block.ts'
import { locate } from './locate.ts'

/** The spring by velocity Verlet, which keeps the acceleration at the end of a step for the next. */
export class SpringVerlet implements HandwrittenBlock {
  s = NaN
  v = NaN
  heat = NaN
  slip: -1 | 0 | 1 = 0
  readonly clock = new HandwrittenClock()
  private a = NaN
  // Where a tried step ends.
  private s1 = NaN
  private v1 = NaN
  private a1 = NaN
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
      this.a = this.a1
      left -= h
      if (stops) this.chooseSlip()
      if (!(Math.abs(this.s) < FAR)) this.slip = 0
    }
  }

  tryStep(h: number): void {
    const { s, v, a } = this
    const s1 = s + (v + 0.5 * a * h) * h
    const a1 = this.tangential - this.perMetre * s1 - this.slip * this.friction
    this.s1 = s1
    this.v1 = v + 0.5 * (a + a1) * h
    this.a1 = a1
  }

  private locateStop(h: number): number {
    return locate(this, h, () => this.slip * this.v1)
  }

  private chooseSlip(): void {
    const pull = this.tangential - this.perMetre * this.s
    this.slip = slipDirection(this.v, pull, this.hold)
    this.a = pull - this.slip * this.friction
  }
}
