import { scaleOf, withoutRounding } from '../measure/index.ts'
import { lengthText, place, seconds } from '../chart/numbers.ts'
import { rowAt } from '../view/timeline.ts'
import { errorAt } from './state/simulation.ts'
import type { Simulated, SimulatedRunner } from './state/simulation.ts'

/** What the picture shows at a time [s], in a sentence for each visible runner, with the exact block or without. */
export function describe(simulated: Simulated, time: number, withoutExact = false): string {
  const { scene, visible, exact, state } = simulated
  const start = state.parameters.position!
  const travelled = exact(time, { s: 0, v: 0 }).s - start
  const sentences = visible.map((runner) => {
    const row = rowAt(runner.trajectory, time)
    const scale = scaleOf(runner.trajectory.experiment).length
    const error = withoutRounding(errorAt(runner.trajectory, exact, row), scale)
    const distance = Math.abs(runner.trajectory.drawnS[row]! - start)
    const off = withoutExact ? '' : `, ${gap(error, travelled)}`
    return `${runner.name}: ${stateText(runner, row)} ${place(distance)}${off}.`
  })
  return [`${scene.label} after ${seconds(time)}.`, ...sentences].join(' ')
}

function stateText({ trajectory }: SimulatedRunner, row: number): string {
  const { kind, time } = trajectory.outcome
  const over = time <= trajectory.stateTime[row]!
  if (kind === 'at-rest' && over) return 'stopped at'
  if (kind === 'left-the-track' && over) return `left the track after ${seconds(time)} at`
  if (trajectory.abandoned && over)
    return `could not keep to its tolerance after ${seconds(time)}, last seen at`
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
