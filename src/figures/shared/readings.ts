import { traceFrame } from '../../physics/index.ts'
import type { Trajectory } from '../../physics/index.ts'
import { withoutRounding } from '../../measure/index.ts'
import { roughMetres } from '../../chart/numbers.ts'

/** A physics step inside a frame. */
export interface Step {
  /** The time that the state stands at when it ends [s]. */
  readonly time: number
  /** The row of the frame that took it. */
  readonly row: number
}

const kept = new WeakMap<Trajectory, readonly Step[]>()

/** Every step of a run that was not taken back. */
export function stepsOf(run: Trajectory): readonly Step[] {
  let ticks = kept.get(run)
  if (!ticks) {
    const all: Step[] = []
    for (let row = 1; row <= run.frames; row++) {
      let time = run.stateTime[row - 1]!
      for (const { dt, takenBack } of traceFrame(run.experiment, row))
        if (!takenBack) all.push({ time: (time += dt), row })
    }
    kept.set(run, (ticks = all))
  }
  return ticks
}

/** A distance [m] to two digits, on the paths of some metres that the figures have: “0.048 m”, “3.2 mm”. */
export function roughly(distance: number): string {
  return roughMetres(withoutRounding(distance, 1))
}
