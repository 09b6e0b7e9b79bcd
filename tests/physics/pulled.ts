import { lawOf } from '../../src/physics/law.ts'
import { Motion } from '../../src/physics/motion.ts'
import { straight } from '../../src/physics/track.ts'

/** dv/dt at a distance and a speed [m/s²]. */
export type Pull = (s: number, v: number) => number

/** A motion under an acceleration of any kind: all that an integrator asks a motion for. */
export class PulledMotion extends Motion {
  private readonly pull: Pull

  constructor(pull: Pull, s: number, v: number, dt: number) {
    // In air, so that no acceleration serves two steps.
    super(lawOf([straight(0)], { drag: 1 }), s, v, true)
    this.pull = pull
    this.dt = dt
  }

  override acceleration(s: number, v: number): number {
    this.evaluations++
    return this.pull(s, v)
  }
}
