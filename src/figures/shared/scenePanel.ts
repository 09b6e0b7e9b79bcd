import { exactMotion, parseExperiment, scenes } from '../../physics/index.ts'
import type { Trajectory } from '../../physics/index.ts'
import type { Picture } from '../../view/picture.ts'
import { drawScene } from '../../view/scenePicture.ts'
import type { DrawingSurface } from './figure.ts'

type Still = Omit<Picture, 'time'>

/** By the first of its runs: a picture that only the time has changed is quick to draw. */
const kept = new WeakMap<Trajectory, { runs: readonly Trajectory[]; names: string; still: Still }>()

/** What the lab's picture shows of some runs, with nothing to take hold of. */
function stillOf(runs: readonly Trajectory[], names: readonly string[]): Still {
  const first = runs[0]!
  const known = kept.get(first)
  const key = names.join()
  if (
    known?.names === key &&
    runs.length === known.runs.length &&
    runs.every((run, i) => run === known.runs[i])
  )
    return known.still
  const { scene, parameters, duration } = parseExperiment(first.experiment)
  const still: Still = {
    scene: scenes.find(({ id }) => id === scene)!,
    parameters,
    duration,
    runners: runs.map((trajectory, paletteIndex) => ({
      trajectory,
      paletteIndex,
      name: names[paletteIndex]!,
    })),
    exact: exactMotion(first.experiment),
    handles: [],
  }
  kept.set(first, { runs, names: key, still })
  return still
}

/** Draws the lab's picture of some runs at an instant [s]. */
export function drawRuns(
  surface: DrawingSurface,
  runs: readonly Trajectory[],
  names: readonly string[],
  time: number,
): void {
  drawScene(surface.context, { ...stillOf(runs, names), time }, surface, surface.palette)
}
