import { exactMotion, scenes } from '../../physics/index.ts'
import type { ExactMotion, Scene, Trajectory } from '../../physics/index.ts'
import { spreadOf } from '../../measure/index.ts'
import type { Spread } from '../../measure/index.ts'
import { experimentOf } from './check.ts'
import { namesOf } from './names.ts'
import { RunCache } from './runCache.ts'
import type { LabState, RunnerState } from './state.ts'

/** A runner, and all that it did. */
export interface SimulatedRunner {
  readonly state: RunnerState
  readonly name: string
  readonly trajectory: Trajectory
}

/** A lab state, run from beginning to end. */
export interface Simulated {
  readonly state: LabState
  readonly scene: Scene
  /** The true motion as it is to be seen: at a time on the wall, the state that the time scale says [s]. */
  readonly exact: ExactMotion
  readonly runners: readonly SimulatedRunner[]
  /** Those that are not hidden. */
  readonly visible: readonly SimulatedRunner[]
  /** How far apart the visible runners end; undefined where none is visible. */
  readonly spread: Spread | undefined
}

/** Runs lab states. What did not change since the state before is not run again. */
export class Simulation {
  private readonly cache = new RunCache()

  run(state: LabState): Simulated {
    const names = namesOf(state.runners)
    const runs = this.cache.run(state.runners.map((runner) => experimentOf(state, runner)))
    const runners = state.runners.map((runner, i) => {
      return { state: runner, name: names[i]!, trajectory: runs[i]! }
    })
    const visible = runners.filter((runner) => !runner.state.hidden)
    return {
      state,
      scene: scenes.find(({ id }) => id === state.scene)!,
      exact: shownMotion(state),
      runners,
      visible,
      spread:
        visible.length > 0 ? spreadOf(visible.map(({ trajectory }) => trajectory)) : undefined,
    }
  }
}

function shownMotion(state: LabState): ExactMotion {
  const motion = exactMotion(experimentOf(state, state.runners[0]!))
  const { timeScale } = state
  return timeScale === 1 ? motion : (t, into) => motion(timeScale * t, into)
}

/** How far a row of a run is from the exact block as the picture shows it: drawnS − exact(time) [m]. */
export function errorAt({ drawnS, time }: Trajectory, exact: ExactMotion, row: number): number {
  return drawnS[row]! - exact(time[row]!, { s: 0, v: 0 }).s
}
