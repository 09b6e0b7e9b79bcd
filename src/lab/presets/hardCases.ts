import { hardCases } from '../../measure/hardCases/index.ts'
import type { HardCase } from '../../measure/hardCases/index.ts'
import { scenes } from '../../physics/index.ts'
import type { Experiment, Scene } from '../../physics/index.ts'
import { count, plain } from '../../chart/numbers.ts'
import { preset } from './preset.ts'
import type { Preset } from './preset.ts'
import { durationOf, stateOf, together } from './stateOf.ts'

/** What the numbers of the hard cases' groups are called in the menu. */
export const groups: readonly (readonly [string, readonly number[]])[] = [
  ['Stopping and staying', [1, 2, 3, 4, 5, 6]],
  ['Frames and clocks', [7, 8, 17]],
  ['Swings', [9, 10, 11, 12]],
  ['Stops and joints', [14, 15]],
  ['Extreme numbers', [13, 16]],
]

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
  const parts = together(experiments)
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
