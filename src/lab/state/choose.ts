import { frameClocks, timesteps } from '../../physics/index.ts'
import type { Options } from '../../physics/index.ts'
import type { RunnerState } from './state.ts'

/**
 * The value of a runner's frame clock or timestep after another was chosen from the menu: the options that both have
 * keep their values, the others are at their initial ones. A bound that was none is none to keep.
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
  return { kind, ...Object.fromEntries(values) } as RunnerState[Of]
}
