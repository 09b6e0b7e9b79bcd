import type { State, Trajectory } from '../../physics/index.ts'
import {
  energyResidual,
  presentationErrors,
  scaleOf,
  withoutRounding,
} from '../../measure/index.ts'
import { residualText } from '../../chart/magnitudes.ts'
import { fixed, place, plain } from '../../chart/numbers.ts'

/** Something that a plot shows of every frame of a run. */
export interface PlotQuantity {
  readonly label: string
  readonly unit: string
  /** One number for each row of a trajectory. */
  values(trajectory: Trajectory): Float64Array
  /** The true motion's, where that has one to draw. */
  ofExact?(state: Readonly<State>): number
  /** As people read it, with its unit. */
  text(value: number): string
  /** The least stretch that an axis shows: below it, a constant would look like a mountain range. */
  readonly least: number
  /** It should be 0; what is rounding is given as 0. */
  readonly residual?: true
  readonly logarithmic?: true
}

const thin = '\u202f'

/** Where each frame shows the block [m]. */
export const shownPosition: PlotQuantity = {
  label: 'position',
  unit: 'm',
  values: ({ drawnS }) => drawnS,
  ofExact: ({ s }) => s,
  text: (value) => place(value),
  least: 0.01,
}

/** Where the physics has the block [m]. */
export const position: PlotQuantity = { ...shownPosition, values: ({ s }) => s }

/** [m/s] */
export const speed: PlotQuantity = {
  label: 'speed',
  unit: 'm/s',
  values: ({ v }) => v,
  ofExact: ({ v }) => v,
  text: (value) => `${Math.abs(value) < 1000 ? fixed(value, 2) : plain(value)}${thin}m/s`,
  least: 0.01,
}

/** How far what is shown is from the exact block, |drawnS − exact(time)| [m]. */
export const error: PlotQuantity = {
  label: 'error',
  unit: 'm',
  values: remembered((trajectory) => {
    const { length } = scaleOf(trajectory.experiment)
    return presentationErrors(trajectory).each.map((each) =>
      withoutRounding(Math.abs(each), length),
    )
  }),
  text: (value) => residualText(value, 'm'),
  least: 0,
  residual: true,
  logarithmic: true,
}

/** Kinetic + potential + heat − what there was at the start [J]. */
export const energy: PlotQuantity = {
  label: 'energy residual',
  unit: 'J',
  values: remembered((trajectory) => {
    const { energy } = scaleOf(trajectory.experiment)
    return energyResidual(trajectory).map((each) => withoutRounding(each, energy))
  }),
  ofExact: () => 0,
  text: (value) => residualText(value, 'J'),
  least: 0.001,
  residual: true,
}

/** The values of a run are worked out once, however often it is drawn. */
function remembered(values: (trajectory: Trajectory) => Float64Array): PlotQuantity['values'] {
  const kept = new WeakMap<Trajectory, Float64Array>()
  return (trajectory) => {
    let known = kept.get(trajectory)
    if (!known) kept.set(trajectory, (known = values(trajectory)))
    return known
  }
}
