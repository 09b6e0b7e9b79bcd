import { trajectoryErrors, withoutRounding } from '../../measure/index.ts'
import { exact, forcesAt, simulate } from '../../physics/index.ts'
import type { Experiment, IntegratorId } from '../../physics/index.ts'
import { fixed, metres } from '../../chart/numbers.ts'
import { at } from './experiments.ts'
import type { Facts } from './fact.ts'

// 30°, μk = 0.2, two seconds from rest: the scene's defaults.
const ramp: Experiment = { scene: 'ramp', duration: 2 }
const millimetres = (value: number) => `${fixed(value, 3)}\u202fm`
const error = (integrator: IntegratorId, fps: number) =>
  trajectoryErrors(simulate(at(fps, { ...ramp, integrator }))).atEnd

/** ½aTΔt. */
function predicted(fps: number): number {
  const a = forcesAt(ramp, { s: 0, v: 1 }).acceleration
  return (0.5 * Math.sqrt(a.x * a.x + a.y * a.y) * 2) / fps
}

/** The largest height that a jump at 5 m/s is seen at. */
function jump(integrator: IntegratorId, fps: number): number {
  const experiment: Experiment = { scene: 'fall', parameters: { speed: -5 }, duration: 1 }
  return -Math.min(...simulate(at(fps, { ...experiment, integrator })).s)
}

/** A slide of two seconds, and a jump. */
export const toPosition = {
  rampTrue: { value: () => exact(ramp, 2).s, show: millimetres },
  rampPredicted60: { value: () => predicted(60), show: millimetres },
  rampMeasured60: { value: () => error('semi-implicit-euler', 60), show: millimetres },
  rampMeasured30: { value: () => error('semi-implicit-euler', 30), show: millimetres },
  rampMeasured5: { value: () => error('semi-implicit-euler', 5), show: millimetres },
  rampVerlet: {
    value: () =>
      Math.max(
        ...[5, 30, 60].map((fps) =>
          // The way is some metres long.
          withoutRounding(Math.abs(error('velocity-verlet', fps)), 1),
        ),
      ),
    show: metres,
  },
  // v²/2g.
  jumpTrue: { value: () => 25 / (2 * 9.81), show: metres },
  jump144: { value: () => jump('semi-implicit-euler', 144), show: metres },
  jump30: { value: () => jump('semi-implicit-euler', 30), show: metres },
} as const satisfies Facts
