import type { ArrowId, PictureForces, PictureVector } from '../../view/picture.ts'
import { rowAt } from '../../view/timeline.ts'
import { forcesOf, largestOf } from './forces.ts'
import type { Forces, Largest } from './forces.ts'
import type { LabView } from '../../lab/labView.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'

/** What an arrow is called, and the letters at its tip. */
export interface ArrowName {
  readonly id: ArrowId
  readonly tag: string
  readonly name: string
}

/** The arrows that a scene can have, in the order in which they are told. */
export function arrowNames({ simulated: { state } }: LabView): ArrowName[] {
  const { scene, parameters } = state
  const names: (ArrowName | false)[] = [
    { id: 'gravity', tag: 'G', name: 'Gravity' },
    scene !== 'fall' && { id: 'normal', tag: 'N', name: 'Normal force' },
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
  readonly forces: Forces | undefined
  readonly largest: Largest
}

/** What is looked at closely: undefined if it is hidden. */
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
