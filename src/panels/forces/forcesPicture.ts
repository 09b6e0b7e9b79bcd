import { exactMotion, forcesAt, length } from '../../physics/index.ts'
import type { ForceVectors, State, Trajectory, Vector } from '../../physics/index.ts'
import type { ArrowId, PictureForces, PictureVector } from '../../view/picture.ts'
import { viewOf } from '../../view/scenes.ts'
import { endOf, rowAt } from '../../view/timeline.ts'
import type { LabView } from '../../lab/labView.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'

/** The forces on a runner's block in one row of its run. */
export interface BlockForces {
  /** As physics has them [N]. */
  readonly vectors: ForceVectors
  /** [m/s], along the track. */
  readonly velocity: Vector
}

/**
 * The forces that a step begins with at a row's physics state; undefined where the run has left the track or
 * diverged, so that there is no block any more.
 */
export function forcesOf({ trajectory, row }: RunRow): BlockForces | undefined {
  const end = endOf(trajectory)
  if (end && end.kind !== 'at-rest' && row >= end.row) return undefined
  const { s, v } = trajectory
  return forcesIn(trajectory, { s: s[row]!, v: v[row]! })
}

/** A row of a run. */
interface RunRow {
  readonly trajectory: Trajectory
  readonly row: number
}

function forcesIn({ experiment }: Pick<Trajectory, 'experiment'>, state: State): BlockForces {
  const vectors = forcesAt(experiment, state)
  const { along } = vectors
  return { vectors, velocity: { x: state.v * along.x, y: state.v * along.y } }
}

/** The largest force of a run [N] and its largest speed [m/s]: what arrows are drawn to scale with. */
export interface Largest {
  readonly force: number
  readonly speed: number
}

/** The number of states in which a run's largest force is looked for: one every few pixels. */
const SAMPLES = 120
/** A run that blows up counts as far as this many times the true motion; what is beyond can't be drawn to scale. */
const REACH = 3

const kept = new WeakMap<Trajectory, Largest>()

/** The largest force and speed of a whole run, so that arrows keep their scale while it plays. */
export function largestOf(trajectory: Trajectory): Largest {
  const known = kept.get(trajectory)
  if (known) return known
  const { experiment, frames, s, v } = trajectory
  const exact = exactMotion(experiment)
  const truth = largest(
    trajectory,
    samples(SAMPLES, experiment.timeScale * experiment.duration).map((t) =>
      exact(t, { s: 0, v: 0 }),
    ),
  )
  const rows = samples(Math.min(frames, SAMPLES), frames).map(Math.round)
  const run = largest(
    trajectory,
    [...rows, indexOfLargest(v)].map((row) => ({ s: s[row]!, v: v[row]! })),
  )
  const both = {
    force: Math.max(truth.force, Math.min(run.force, REACH * truth.force)),
    speed: Math.max(truth.speed, Math.min(run.speed, REACH * truth.speed || Infinity)),
  }
  kept.set(trajectory, both)
  return both
}

function largest(trajectory: Pick<Trajectory, 'experiment'>, states: readonly State[]): Largest {
  let force = 0
  let speed = 0
  for (const state of states) {
    const { gravity, normal, friction, other, sum } = forcesIn(trajectory, state).vectors
    force = Math.max(force, ...[gravity, normal, friction, other, sum].map(length))
    speed = Math.max(speed, Math.abs(state.v))
  }
  return { force, speed }
}

/** From 0 to an end in equal parts. */
function samples(parts: number, end: number): number[] {
  return Array.from({ length: parts + 1 }, (_, i) => (parts > 0 ? (end * i) / parts : 0))
}

function indexOfLargest(values: Float64Array): number {
  let best = 0
  for (let i = 1; i < values.length; i++)
    if (Math.abs(values[i]!) > Math.abs(values[best]!)) best = i
  return best
}

/** What an arrow is called, and the letters at its tip. */
export interface ArrowName {
  readonly id: ArrowId
  readonly tag: string
  readonly name: string
}

/** The arrows that a scene can have, in the order in which they are told. */
export function arrowNames({ simulated: { scene, state } }: LabView): ArrowName[] {
  const { parameters } = state
  const names: (ArrowName | false)[] = [
    { id: 'gravity', tag: 'G', name: 'Gravity' },
    !viewOf(scene).falls && { id: 'normal', tag: 'N', name: 'Normal force' },
    'muKinetic' in parameters && { id: 'friction', tag: 'F', name: 'Friction' },
    'stiffness' in parameters && { id: 'other', tag: 'S', name: 'Spring' },
    'drag' in parameters && { id: 'other', tag: 'D', name: 'Drag' },
    { id: 'sum', tag: 'ΣF', name: 'Sum' },
    { id: 'velocity', tag: 'v', name: 'Velocity' },
  ]
  return names.filter((name) => name !== false)
}

/** The selected runner at the cursor, if it can be seen. */
export interface Looked {
  readonly runner: SimulatedRunner
  readonly row: number
  /** Undefined where there is no block any more. */
  readonly forces: BlockForces | undefined
  readonly largest: Largest
}

/** The selected runner's row and forces; undefined if it is hidden. */
export function lookedAt({ simulated, selected, playback }: LabView): Looked | undefined {
  const runner = simulated.runners[selected]
  if (!runner || runner.state.hidden) return undefined
  const { trajectory } = runner
  const row = rowAt(trajectory, playback.time)
  return { runner, row, forces: forcesOf({ trajectory, row }), largest: largestOf(trajectory) }
}

/** The same for the picture: plain vectors. */
export function pictureForces(lab: LabView): PictureForces | undefined {
  const looked = lookedAt(lab)
  if (!looked?.forces) return undefined
  const { forces, largest } = looked
  const vectors = arrowNames(lab).map(({ id, tag }): PictureVector => {
    const { x, y } = id === 'velocity' ? forces.velocity : forces.vectors[id]
    return { id, tag, x, y }
  })
  const { along, across } = forces.vectors
  return { vectors, along, across, largest: largest.force, fastest: largest.speed }
}
