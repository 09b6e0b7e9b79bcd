import type { Trajectory } from '../../physics/index.ts'
import { place, raw, seconds } from '../../chart/numbers.ts'
import { endOf } from '../../view/timeline.ts'

const words = { 'at-rest': '', 'left-the-track': 'left the track', diverged: 'diverged' }

/** When and where a run stopped, or what else became of it: “0.70 s · 1.47 m”, “moving”, “diverged 1.20 s”. */
export function endText(trajectory: Trajectory): { text: string; title: string } {
  const { drawnS, v, frames, experiment } = trajectory
  const end = endOf(trajectory)
  if (!end && v[frames] === 0)
    return { text: 'at a stop', title: 'Its speed is 0 as the run is over' }
  if (!end) return { text: 'moving', title: 'Still moving when the run is over' }
  const { kind, time } = end
  const way = Math.abs(drawnS[frames]! - experiment.parameters.position!)
  const title = `t = ${raw(time)} s, ${raw(way)} m from the start`
  if (kind === 'at-rest') return { text: `${seconds(time)} · ${place(way)}`, title }
  return { text: `${words[kind]} ${seconds(time)}`, title }
}
