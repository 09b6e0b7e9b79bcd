import { HandwrittenClock, FAR, slipDirection } from './block.ts'
import type { HandwrittenBlock, Given } from './block.ts'

/** The ramp by the classical Runge–Kutta method: the acceleration is constant, so that a stop is found by a division. */
export class RampRk4 implements HandwrittenBlock {
  s = NaN
  v = NaN
  heat = NaN
  slip: -1 | 0 | 1 = 0
  readonly clock = new HandwrittenClock()
  private a = NaN
  private readonly tangential: number
  private readonly hold: number
  private readonly friction: number
  private readonly mass: number

  constructor({ angle, muStatic, muKinetic, gravity, mass, position, speed }: Given) {
    const alpha = (angle! * Math.PI) / 180
    const normal = gravity! * Math.cos(alpha)
    this.tangential = gravity! * Math.sin(alpha)
    this.hold = muStatic! * normal
    this.friction = muKinetic! * normal
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
      const { s, v, a, slip } = this
      let h = left
      let v1 = v + (h * (a + 2 * (a + a) + a)) / 6
      const stops = slip * v1 < 0
      if (stops) {
        h = -v / a
        v1 = 0
      }
      const v2 = v + 0.5 * h * a
      const v3 = v + 0.5 * h * a
      const v4 = v + h * a
      const s1 = s + (h * (v + 2 * (v2 + v3) + v4)) / 6
      this.heat += this.mass * this.friction * Math.abs(s1 - s)
      this.s = s1
      this.v = v1
      left -= h
      if (stops) this.chooseSlip()
      if (!(Math.abs(s1) < FAR)) this.slip = 0
    }
  }

  private chooseSlip(): void {
    this.slip = slipDirection(this.v, this.tangential, this.hold)
    this.a = this.tangential - this.slip * this.friction
  }
}
