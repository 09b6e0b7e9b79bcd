import { energyResidual, presentationErrors } from '../../measure/index.ts'
import type { State, Trajectory } from '../../physics/index.ts'
import { fixed, place, plain } from '../../chart/numbers.ts'

/** Something that a plot shows of every frame of a run. */
export interface Quantity {
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
  /** It should be 0, and is never quite: below some size it is rounding. */
  readonly residual?: true
  readonly logarithmic?: true
}

/** What an error of 0 is drawn as [m]: a logarithm has no place for it. */
const FLOOR = 1e-16

/** Below this an error is an accident of rounding, as it is in all texts [m]. */
export const ROUNDING = 1e-11

const thin = '\u2009'

/** Where each frame shows the block [m]. */
export const shownPosition: Quantity = {
  label: 'position',
  unit: 'm',
  values: ({ drawnS }) => drawnS,
  ofExact: ({ s }) => s,
  text: (value) => place(value),
  least: 0.01,
}

/** Where the physics has the block [m]. */
export const position: Quantity = { ...shownPosition, values: ({ s }) => s }

/** [m/s] */
export const speed: Quantity = {
  label: 'speed',
  unit: 'm/s',
  values: ({ v }) => v,
  ofExact: ({ v }) => v,
  text: (value) => `${Math.abs(value) < 1000 ? fixed(value, 2) : plain(value)}${thin}m/s`,
  least: 0.01,
}

/** How far what is shown is from the exact block, |drawnS − exact(time)|, at least the floor [m]. */
export const error: Quantity = {
  label: 'error',
  unit: 'm',
  values: remembered((trajectory) =>
    presentationErrors(trajectory).each.map((each) => Math.max(FLOOR, Math.abs(each))),
  ),
  text: (value) => small(value, 'm'),
  least: 0,
  residual: true,
  logarithmic: true,
}

/** Kinetic + potential + heat − what there was at the start [J]. */
export const energy: Quantity = {
  label: 'energy residual',
  unit: 'J',
  values: remembered(energyResidual),
  ofExact: () => 0,
  text: (value) => small(value, 'J'),
  least: 0.001,
  residual: true,
}

/** A figure that should be 0, from thousands down to rounding, in little room: “0.146 m”, “−5.54 mJ”, “12 pm”. */
function small(value: number, unit: string): string {
  const size = Math.abs(value)
  if (size > 0 && size < ROUNDING) return 'rounding'
  if (size >= 1000 || size === 0 || Number.isNaN(size)) return `${plain(value)}${thin}${unit}`
  // Where thousandths say enough all have them, so that points stand under points.
  if (size >= 0.01) return `${fixed(value, 3)}${thin}${unit}`
  const steps = size >= 1e-3 ? 1 : size >= 1e-6 ? 2 : size >= 1e-9 ? 3 : 4
  return `${plain(value * 1000 ** steps)}${thin}${'mµnp'[steps - 1]!}${unit}`
}

/** The values of a run are worked out once, however often it is drawn. */
function remembered(values: (trajectory: Trajectory) => Float64Array): Quantity['values'] {
  const kept = new WeakMap<Trajectory, Float64Array>()
  return (trajectory) => {
    let known = kept.get(trajectory)
    if (!known) kept.set(trajectory, (known = values(trajectory)))
    return known
  }
}
