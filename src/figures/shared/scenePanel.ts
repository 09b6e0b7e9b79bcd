import { exactMotion, parseExperiment, scenes } from '../../physics/index.ts'
import type { Trajectory } from '../../physics/index.ts'
import { plainBackdrop } from '../../view/backdrop.ts'
import { layOut } from '../../view/layout.ts'
import { paint } from '../../view/paint.ts'
import type { Picture } from '../../view/picture.ts'
import { settingOf } from '../../view/setting.ts'
import type { Setting } from '../../view/setting.ts'
import type { DrawingSurface } from './figure.ts'

interface Kept {
  readonly runs: readonly Trajectory[]
  readonly names: string
  readonly setting: Setting
}

/** By the first of its runs: a picture that only the time has changed is not laid out again. */
const kept = new WeakMap<Trajectory, Kept>()

/** The lab's picture of some runs, with nothing to take hold of, laid out on a surface. */
function settingFor(
  runs: readonly Trajectory[],
  names: readonly string[],
  { width, height }: DrawingSurface,
): Setting {
  const first = runs[0]!
  const known = kept.get(first)
  const key = names.join()
  if (
    known?.names === key &&
    known.setting.layout.width === width &&
    known.setting.layout.height === height &&
    runs.length === known.runs.length &&
    runs.every((run, i) => run === known.runs[i])
  )
    return known.setting
  const { scene, parameters, duration } = parseExperiment(first.experiment)
  const picture: Picture = {
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
    time: 0,
  }
  const setting = settingOf(picture, layOut(picture, width, height))
  kept.set(first, { runs, names: key, setting })
  return setting
}

/** Draws the lab's picture of some runs at an instant [s]. */
export function drawRuns(
  surface: DrawingSurface,
  runs: readonly Trajectory[],
  names: readonly string[],
  time: number,
): void {
  const setting = settingFor(runs, names, surface)
  paint(surface.context, { ...setting.picture, time }, setting, surface.palette, plainBackdrop)
}
