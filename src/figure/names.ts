import { frameClocks, integrators, stoppings, timesteps } from '../physics/index.ts'
import { shownNumber } from './numberText.ts'
import type { RunnerState } from './state.ts'

/**
 * A short name for each runner: its frames, or where these don't tell all runners apart, as much more (or else) of what
 * differs as it takes.
 */
export function namesOf(runners: readonly RunnerState[]): string[] {
  const parts = runners.map((runner) => [
    framesText(runner),
    label(integrators, runner.integrator),
    label(stoppings, runner.stopping),
    label(timesteps, runner.timestep.kind),
  ])
  let names = parts.map(() => '')
  for (let i = 0; i < parts[0]!.length; i++) {
    const differs = parts.some((part) => part[i] !== parts[0]![i])
    if (differs && new Set(names).size < names.length)
      names = names.map((name, n) => (name ? `${name} · ${parts[n]![i]}` : parts[n]![i]!))
  }
  return names.map((name, n) => name || parts[n]![0]!)
}

/** “30 fps”, “30 fps, jitter”. */
function framesText({ frames }: RunnerState): string {
  const clock = label(frameClocks, frames.kind)
  if (!('fps' in frames)) return clock
  const rate = `${shownNumber(frames.fps)} fps`
  return frames.kind === 'steady' ? rate : `${rate}, ${clock.toLowerCase()}`
}

function label(list: readonly { id: string; label: string }[], id: string): string {
  return list.find((each) => each.id === id)!.label
}
