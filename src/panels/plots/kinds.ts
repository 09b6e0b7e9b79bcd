import { viewOf } from '../../view/scenes.ts'
import type { Simulated } from '../../lab/state/simulation.ts'
import { energy, error, position, shownPosition, speed } from './quantity.ts'
import type { PlotQuantity } from './quantity.ts'

/** One of the plots: a quantity over time, or over another quantity. */
export interface PlotKind {
  readonly id: string
  readonly title: string
  /** What it shows, in a few words. */
  caption(simulated: Simulated): string
  /** Undefined: over time. */
  readonly over?: PlotQuantity
  readonly of: PlotQuantity
}

/** Every plot of the lab, in the order in which they stand. */
export const plotKinds: readonly PlotKind[] = [
  {
    id: 'position',
    title: 'Position',
    caption: ({ scene }) => `as each frame shows it; ${viewOf(scene).forwards} is plus`,
    of: shownPosition,
  },
  { id: 'speed', title: 'Speed', caption: () => 'along the track', of: speed },
  {
    id: 'phase',
    title: 'Speed over position',
    caption: () => 'one point a frame: the state of the physics',
    over: position,
    of: speed,
  },
  {
    id: 'error',
    title: 'Error',
    caption: () => 'distance from the exact block, by powers of ten',
    of: error,
  },
  {
    id: 'energy',
    title: 'Energy residual',
    caption: () =>
      'kinetic + potential + heat of friction and drag − what there was at the start; 0 is right',
    of: energy,
  },
]
