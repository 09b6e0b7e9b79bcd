import type { Trajectory } from '../../physics/index.ts'
import { scaleOf, withoutRounding } from '../../measure/index.ts'
import { fixed, metres, place, raw, seconds } from '../../chart/numbers.ts'
import { endOf } from '../../view/timeline.ts'
import { errorAt } from '../../lab/state/simulation.ts'
import type { Simulated } from '../../lab/state/simulation.ts'

/**
 * How far a run is from the exact block in one of its rows, signed as in the picture: minus is to the left of the exact
 * block, or above it where everything falls.
 */
export function errorText(
  { exact, scene }: Simulated,
  trajectory: Trajectory,
  row: number,
): { text: string; title: string } {
  const error = errorAt(trajectory, exact, row)
  return {
    text: signed(scene.facing * withoutRounding(error, scaleOf(trajectory.experiment).length)),
    title: `s − exact(t) = ${raw(error)} m, at t = ${raw(trajectory.time[row]!)} s`,
  }
}

function signed(error: number): string {
  const size = Math.abs(error)
  // Where millimetres say enough, all rows have them, so that points stand under points.
  const text = size >= 0.001 && size < 1000 ? `${fixed(error, 3)}\u202fm` : metres(error)
  return error > 0 && /[1-9]/.test(text) ? `+${text}` : text
}

const words = { 'at-rest': '', 'left-the-track': 'left the track', diverged: 'diverged' }

/** When and where a run stopped, or what else became of it: “0.70 s · 1.47 m”, “moving”, “diverged 1.20 s”. */
export function endText(trajectory: Trajectory): { text: string; title: string } {
  const { drawnS, v, frames, experiment } = trajectory
  const end = endOf(trajectory)
  if (!end && v[frames] === 0)
    return { text: 'at a stop', title: 'Its speed is 0 when the run ends' }
  if (!end) return { text: 'moving', title: 'Still moving when the run ends' }
  const { kind, time } = end
  const way = Math.abs(drawnS[frames]! - experiment.parameters.position!)
  const title = `t = ${raw(time)} s, ${raw(way)} m from the start`
  if (kind === 'at-rest') return { text: `${seconds(time)} · ${place(way)}`, title }
  const what = trajectory.abandoned ? 'tolerance not met' : words[kind]
  return { text: `${what} ${seconds(time)}`, title }
}
