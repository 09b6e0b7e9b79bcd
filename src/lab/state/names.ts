import { frameClocks, integrators, stoppings, timesteps } from '../../physics/index.ts'
import type { Options } from '../../physics/index.ts'
import { shownNumber } from '../../chart/numbers.ts'
import type { RunnerState } from './state.ts'

/**
 * A short name for each runner: its frames, or where these don't tell all runners apart, as much of what differs as it
 * takes.
 */
export function namesOf(runners: readonly RunnerState[]): string[] {
  const parts = runners.map((runner) => [
    framesText(runner),
    runner.engine,
    label(integrators, runner.integrator),
    label(stoppings, runner.stopping),
    label(timesteps, runner.timestep.kind),
    ...keysOf(runners, 'timestep').map((key) => optionText(runner.timestep, key, timesteps)),
    ...keysOf(runners, 'frames').map((key) => optionText(runner.frames, key, frameClocks)),
  ])
  let names = parts.map(() => '')
  for (let i = 0; i < parts[0]!.length; i++) {
    const differs = parts.some((part) => part[i] !== parts[0]![i])
    if (differs && new Set(names).size < names.length)
      names = names.map((name, n) => [name, parts[n]![i]].filter(Boolean).join(' · '))
  }
  return names.map((name, n) => name || parts[n]![0]!)
}

/** The names of all options that any of them has. */
function keysOf(runners: readonly RunnerState[], of: 'timestep' | 'frames'): string[] {
  return [...new Set(runners.flatMap((runner) => Object.keys(runner[of])))]
}

/** “30 fps”, “30 fps, jitter”, “60 fps, rounded delta”. */
function framesText({ frames }: RunnerState): string {
  const clock = label(frameClocks, frames.kind)
  const { delta, meanOf, snapTo } = frames
  const measured = delta ? [`${delta} delta ${meanOf ?? snapTo ?? ''}`.trim()] : []
  if (!('fps' in frames)) return [clock, ...measured].join(', ')
  const kind = frames.kind === 'steady' ? [] : [clock.toLowerCase()]
  return [`${shownNumber(frames.fps)} fps`, ...kind, ...measured].join(', ')
}

/** “most steps a frame 50”: a number of what is chosen from a list. */
function optionText(
  chosen: { readonly kind: string },
  key: string,
  list: readonly { readonly id: string; readonly options: Options }[],
): string {
  const option = list.find(({ id }) => id === chosen.kind)!.options[key]
  const value = (chosen as Readonly<Record<string, unknown>>)[key]
  if (option?.type !== 'number' || typeof value !== 'number') return ''
  if (value === option.max && option.atMax) return option.atMax
  return `${option.label.toLowerCase()} ${shownNumber(value)} ${option.unit}`.trim()
}

function label(list: readonly { id: string; label: string }[], id: string): string {
  return list.find((each) => each.id === id)!.label
}
