import type { Tries } from '../../physics/index.ts'
import { fixed, seconds } from '../../chart/numbers.ts'
import { rowAt } from '../../view/timeline.ts'
import { clockworkOf } from '../../lab/state/clockwork.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'

/**
 * What is to be said of a runner's time beside its ticks; '' where physics keeps up with the wall, or is to be slower.
 */
export function noteOf({ name, trajectory }: SimulatedRunner, now: number): string {
  const { lostTime, experiment, time, gameTime, stateTime } = trajectory
  if (lostTime > 0) return `${name}: ${seconds(lostTime)} lost`
  const { timestep, frames, timeScale } = experiment
  const isPerFrame = timestep.kind === 'per-frame'
  if (!isPerFrame && !frames.delta) return ''
  const row = rowAt(trajectory, now)
  // Without delta time the game has no clock but its steps.
  const late = timeScale * time[row]! - (isPerFrame ? stateTime : gameTime)[row]!
  const size = `${fixed(Math.abs(late), 2)}\u202fs`
  const lead = Math.abs(late) < 0.005 ? 'on time' : late > 0 ? `${size} behind` : `${size} ahead`
  return `${name}: physics is ${lead}`
}

/** The same as its ticks, in words. */
export function stripText(runner: SimulatedRunner, now: number): string {
  const { name, trajectory } = runner
  const { step, tries, accumulator } = clockworkOf(trajectory)
  const parts = [`${trajectory.frames} frames`]
  if (step !== undefined) {
    const held = accumulator[rowAt(trajectory, now)]!
    parts.push(
      `${trajectory.steps} physics steps of ${seconds(step)}`,
      `${seconds(held)} in the accumulator`,
    )
  }
  if (tries) parts.push(...triedText(trajectory.steps, tries))
  const note = noteOf(runner, now).slice(name.length + 2)
  if (note) parts.push(note)
  return `${name}: ${parts.join(', ')}.`
}

/** “84 physics steps of 0.9 to 21 ms”, “3 tries taken back”. */
function triedText(steps: number, { lengths, accepted }: Tries): string[] {
  const kept = lengths.filter((_, i) => accepted[i]).map((length) => 0.5 * length)
  if (kept.length === 0) return []
  const [shortest, longest] = [Math.min(...kept), Math.max(...kept)]
  const refused = lengths.length - kept.length
  return [
    `${steps} physics steps of ${seconds(shortest)} to ${seconds(longest)}`,
    refused === 1 ? '1 try taken back' : `${refused} tries taken back`,
  ]
}
