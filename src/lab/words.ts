import type { Trajectory } from '../physics/index.ts'
import { fixed, lengthText, metres, place, raw, seconds } from '../chart/numbers.ts'
import { rowAt } from '../view/timeline.ts'
import { errorAt } from './state/simulation.ts'
import type { Simulated, SimulatedRunner } from './state/simulation.ts'

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
    text: signed(scene.facing * error),
    title: `s − exact(t) = ${raw(error)} m, at t = ${raw(trajectory.time[row]!)} s`,
  }
}

function signed(error: number): string {
  const size = Math.abs(error)
  // Where millimetres say enough, all rows have them, so that points stand under points.
  const text = size >= 0.001 && size < 1000 ? `${fixed(error, 3)}\u2009m` : metres(error)
  return error > 0 && /[1-9]/.test(text) ? `+${text}` : text
}

/** What the picture shows at a time [s], in a sentence for each visible runner. */
export function describe(simulated: Simulated, time: number): string {
  const { scene, visible, exact, state } = simulated
  const start = state.parameters.position!
  const travelled = exact(time, { s: 0, v: 0 }).s - start
  const sentences = visible.map((runner) => {
    const row = rowAt(runner.trajectory, time)
    const distance = Math.abs(runner.trajectory.drawnS[row]! - start)
    return `${runner.name}: ${standing(runner, row)} ${place(distance)}, ${gap(errorAt(runner.trajectory, exact, row), travelled)}.`
  })
  return [`${scene.label} after ${seconds(time)}.`, ...sentences].join(' ')
}

function standing({ trajectory }: SimulatedRunner, row: number): string {
  const { kind, time } = trajectory.outcome
  const over = time <= trajectory.stateTime[row]!
  if (kind === 'at-rest' && over) return 'stopped at'
  if (kind === 'left-the-track' && over) return `left the track after ${seconds(time)} at`
  if (kind === 'diverged' && over) return `blew up after ${seconds(time)}, last seen at`
  return 'at'
}

/** An error in words, by the way that the exact block has gone. */
function gap(error: number, travelled: number): string {
  const size = lengthText(Math.abs(error))
  if (!/[1-9]/.test(size)) return 'on the exact block'
  if (Math.abs(travelled) <= Math.abs(error)) return `${size} from the exact block`
  return error * travelled < 0
    ? `${size} short of the exact block`
    : `${size} beyond the exact block`
}
