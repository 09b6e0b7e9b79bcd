import { frameClocks, parseExperiment, scenes } from '../../physics/index.ts'
import type { Experiment, ResolvedExperiment, Scene } from '../../physics/index.ts'
import { hardCases } from '../../measure/hardCases/index.ts'
import type { HardCase } from '../../measure/hardCases/index.ts'
import { count, plain } from '../../chart/numbers.ts'
import { checked } from '../state/check.ts'
import type { LabState } from '../state/state.ts'
import { preset } from './preset.ts'
import type { Preset } from './preset.ts'

/** What the numbers of the hard cases' groups are called in the menu. */
export const groups: readonly (readonly [string, readonly number[]])[] = [
  ['Stopping and staying', [1, 2, 3, 4, 5, 6, 21]],
  ['Frames and clocks', [7, 8, 17]],
  ['Swings', [9, 10, 11, 12, 27]],
  ['Stops and joints', [14, 15]],
  ['Bends, lips and tops', [18, 19, 20]],
  ['Crest and belt', [23, 24]],
  ['Tolerance and heat', [25, 28]],
  ['Extreme numbers', [13, 16, 22, 26]],
]

/** So many frames of all runners together are simulated, and drawn, without a wait that is felt. */
export const MOST_FRAMES = 250_000

/** Each clock reads the options that it has itself from those that were chosen. */
const clocks: readonly {
  readonly id: string
  frames(options: object, duration: number): number
}[] = frameClocks

/** Every hard case: one preset, or as many as it takes to show all of its experiments. */
export const hardPresets: readonly Preset[] = groups.flatMap(([name, numbers]) =>
  hardCases
    .filter(({ group }) => numbers.includes(group))
    .flatMap((hardCase) => presetsOf(hardCase, name)),
)

/** The presets of one case, in a group of the menu. */
export function presetsOf(
  { label, watch, experiments, refused }: HardCase,
  group: string,
): Preset[] {
  const parts = sideBySide(experiments)
  const names = parts.map(([first]) => distinction(first!, parts))
  const areNames = names.every((name, i) => name && names.indexOf(name) === i)
  return parts.map((part, i) => {
    const name = areNames ? names[i]! : `${i + 1} of ${parts.length}`
    const whole = parts.length > 1 ? `${label}: ${name}` : label
    const whatToWatch = refused ? watch : watch + remarkOn(part)
    return preset(group, whole, whatToWatch, () => stateOf(part))
  })
}

/** That a run is only shown in part, if it is. */
function remarkOn(experiments: readonly Experiment[]): string {
  const { duration } = experiments[0]!
  const shown = durationOf(experiments)
  return duration === undefined || shown === duration
    ? ''
    : ` Of ${count(duration)} s, the first ${count(shown)} s are shown here.`
}

/** What an experiment has that others of its case have not: its scene, or a parameter, or its duration. */
function distinction(experiment: Experiment, parts: readonly Experiment[][]): string {
  const firsts = parts.map(([first]) => first!)
  const scene: Scene = scenes.find(({ id }) => id === experiment.scene)!
  if (firsts.some((other) => other.scene !== experiment.scene)) return scene.label.toLowerCase()
  for (const [name, { label, unit }] of Object.entries(scene.parameters)) {
    const value = (experiment: Experiment) =>
      (({ ...experiment.parameters }) as Record<string, number | undefined>)[name]
    const own = value(experiment)
    if (own !== undefined && firsts.some((other) => value(other) !== own))
      return `${label.toLowerCase()} ${plain(own)} ${unit}`.trim()
  }
  return ''
}

/**
 * Experiments as far as they can be shown side by side: those that share scene, parameters and duration are together,
 * in the order in which they come. One that can't be run is alone.
 */
export function sideBySide(experiments: readonly Experiment[]): Experiment[][] {
  const groups = new Map<string, Experiment[]>()
  for (const experiment of experiments) {
    const { scene, parameters, duration } = experiment
    const key = JSON.stringify([scene, parameters, duration])
    groups.set(key, [...(groups.get(key) ?? []), experiment])
  }
  return [...groups.values()]
}

/**
 * The lab that runs such experiments, each as a runner. A run that is longer than a page can bear is cut to its
 * beginning.
 *
 * @throws ExperimentError if they can't be run
 */
export function stateOf(experiments: readonly Experiment[]): LabState {
  const resolved = experiments.map(parseExperiment)
  const { scene, parameters, timeScale } = resolved[0]!
  const runners = resolved.map(({ frames, timestep, integrator, stopping }, paletteIndex) => ({
    ...{ frames, timestep, integrator, stopping },
    ...{ paletteIndex, hidden: false },
  }))
  return checked({ scene, parameters, timeScale, runners, duration: durationOf(experiments) })
}

/** How long they are run there [s]. */
function durationOf(experiments: readonly Experiment[]): number {
  const resolved = experiments.map(parseExperiment)
  const { duration } = resolved[0]!
  const excess = resolved.reduce((sum, each) => sum + frameCount(each), 0) / MOST_FRAMES
  return excess > 1 ? rounded(duration / excess) : duration
}

function frameCount({ frames, duration }: ResolvedExperiment): number {
  return clocks.find(({ id }) => id === frames.kind)!.frames(frames, duration)
}

/** Down to two digits. */
function rounded(x: number): number {
  const unit = 10 ** (Math.floor(Math.log10(x)) - 1)
  return Math.floor(x / unit) * unit
}
