import { fixed, seconds } from '../../chart/numbers.ts'
import { rowAt } from '../../view/timeline.ts'
import { clockworkOf } from '../../lab/state/clockwork.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'

/** What is to be said of a runner's time beside its ticks; '' where physics keeps up with the wall. */
export function noteOf({ name, trajectory }: SimulatedRunner, now: number): string {
  const { lostTime, experiment, time, stateTime } = trajectory
  if (lostTime > 0) return `${name}: ${seconds(lostTime)} lost`
  if (experiment.timestep.kind !== 'per-frame') return ''
  const row = rowAt(trajectory, now)
  const late = time[row]! - stateTime[row]!
  const size = `${fixed(Math.abs(late), 2)}\u202fs`
  const lead = Math.abs(late) < 0.005 ? 'on time' : late > 0 ? `${size} behind` : `${size} ahead`
  return `${name}: physics is ${lead}`
}

/** The same as its ticks, in words. */
export function stripText(runner: SimulatedRunner, now: number): string {
  const { name, trajectory } = runner
  const { step, accumulator } = clockworkOf(trajectory)
  const parts = [`${trajectory.frames} frames`]
  if (step !== undefined) {
    const held = accumulator[rowAt(trajectory, now)]!
    parts.push(
      `${trajectory.steps} physics steps of ${seconds(step)}`,
      `${seconds(held)} in the accumulator`,
    )
  }
  const note = noteOf(runner, now).slice(name.length + 2)
  if (note) parts.push(note)
  return `${name}: ${parts.join(', ')}.`
}
