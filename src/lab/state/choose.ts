import { frameClocks, measuring, timesteps } from '../../physics/index.ts'
import type { Options } from '../../physics/index.ts'
import type { RunnerState } from './state.ts'

/**
 * The value of a runner's frame clock or timestep after another was chosen from the menu: the options that both have
 * keep their values, the others are at their initial ones. An optional bound that was off is not carried over.
 */
export function choose<Of extends 'frames' | 'timestep'>(
  of: Of,
  kind: string,
  before: RunnerState[Of],
): RunnerState[Of] {
  const list = of === 'frames' ? frameClocks : timesteps
  const optionsOf = (id: string): Options => list.find((each) => each.id === id)!.options
  const options = optionsOf(kind)
  const left = optionsOf(before.kind)
  const kept: Readonly<Record<string, unknown>> = Object.fromEntries(
    Object.entries(before).filter(
      ([key, value]) => !(left[key]?.optional && left[key].initial === value),
    ),
  )
  const values = Object.entries(options).map(([key, { initial }]) => [key, kept[key] ?? initial])
  // How frames are measured is the game's own affair, whatever its frames.
  const common = Object.keys(measuring).filter((key) => key in kept)
  return {
    kind,
    ...Object.fromEntries(values),
    ...Object.fromEntries(common.map((key) => [key, kept[key]])),
  } as RunnerState[Of]
}
