import { simulate } from '../../physics/index.ts'
import type { Experiment, Trajectory } from '../../physics/index.ts'

/** Runs experiments. What was run the time before is not run again, and what no longer is asked for is let go. */
export class RunCache {
  private runs = new Map<string, Trajectory>()

  run(experiments: readonly Experiment[]): Trajectory[] {
    const runs = new Map<string, Trajectory>()
    const trajectories = experiments.map((experiment) => {
      const key = JSON.stringify(experiment, named)
      const trajectory = runs.get(key) ?? this.runs.get(key) ?? simulate(experiment)
      runs.set(key, trajectory)
      return trajectory
    })
    this.runs = runs
    return trajectories
  }
}

let count = 0
const names = new WeakMap<object, string>()

/** Lists by name: an experiment that was parsed keeps its list, and 100 000 frame times are much to write. */
function named(_: string, value: unknown): unknown {
  if (!Array.isArray(value)) return value
  const name = names.get(value) ?? `list ${++count}`
  names.set(value, name)
  return name
}
