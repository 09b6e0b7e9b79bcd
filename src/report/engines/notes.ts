import type { EngineScene } from '../schema.ts'
import type { Seen } from './run.ts'

/** What stays within this is at rest: a hundred times what single precision makes of a block 10 m away [m]. */
const STILL = 1e-4

/** What is odd about a run, from its numbers; null where nothing is. */
export function notes(scene: EngineScene, { position, late, lifted, later }: Seen): string | null {
  if (!Number.isFinite(position)) return 'ended as no number'
  const said: string[] = []
  if (Math.abs(lifted) > 0.1) said.push(`${length(lifted)} off the slope`)
  const moves = Math.abs(position - late) > STILL
  if (scene.rests && moves)
    said.push(
      `still moves: ${length(position - late)} in the last ${seconds(0.1 * scene.duration)}`,
    )
  if (!scene.rests && !moves) said.push(`at rest at ${length(position)}, where nothing holds it`)
  if (scene.rests && !moves && later !== null && Math.abs(later - position) > STILL)
    said.push(`creeps ${length(later - position)} while it should rest`)
  return said.length > 0 ? said.join('; ') : null
}

function length(metres: number): string {
  const size = Math.abs(metres)
  return size < 0.1 ? `${(1000 * size).toPrecision(2)} mm` : `${size.toPrecision(3)} m`
}

function seconds(duration: number): string {
  return `${Number(duration.toPrecision(2))} s`
}
