import { scenes } from '../../physics/index.ts'
import type { Parameters, Scene, State, Trajectory } from '../../physics/index.ts'
import {
  energyResidual,
  presentationErrors,
  scaleOf,
  withoutRounding,
} from '../../measure/index.ts'
import { residualText } from '../../chart/magnitudes.ts'
import { fixed, place, plain } from '../../chart/numbers.ts'
import { viewOf } from '../../view/scenes.ts'
import type { Simulated } from '../../lab/state/simulation.ts'

/** Something that a plot shows of every frame of a run. */
export interface PlotQuantity {
  readonly label: string
  readonly unit: string
  /** One number for each row of a trajectory. */
  values(trajectory: Trajectory): Float64Array
  /** The true motion's, where that has one to draw. */
  ofExact?(state: Readonly<State>, simulated: Simulated): number
  /** As people read it, with its unit. */
  text(value: number): string
  /** The least stretch that an axis shows: below it, a constant would look like a mountain range. */
  readonly least: number
  /** It should be 0; what is rounding is given as 0. */
  readonly residual?: true
  readonly logarithmic?: true
  /** Its axis begins at 0. */
  readonly fromZero?: true
}

const thin = '\u202f'

/** Where each frame shows the block [m]. */
const shownPosition: PlotQuantity = {
  label: 'position',
  unit: 'm',
  values: ({ drawnS }) => drawnS,
  ofExact: ({ s }) => s,
  text: (value) => place(value),
  least: 0.01,
}

/** Where the physics has the block [m]. */
const position: PlotQuantity = { ...shownPosition, values: ({ s }) => s }

/** [m/s] */
const speed: PlotQuantity = {
  label: 'speed',
  unit: 'm/s',
  values: ({ v }) => v,
  ofExact: ({ v }) => v,
  text: (value) => `${Math.abs(value) < 1000 ? fixed(value, 2) : plain(value)}${thin}m/s`,
  least: 0.01,
}

/** How far what is shown is from the exact block, |drawnS − exact(time)| [m]. */
const error: PlotQuantity = {
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
const energy: PlotQuantity = {
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

/** What the track pushes the block with, per mass [m/s²]: 0 where the block takes off. */
const press: PlotQuantity = {
  label: 'press',
  unit: 'm/s²',
  values: remembered(({ experiment, s, v }) => {
    const scene: Scene = scenes.find(({ id }) => id === experiment.scene)!
    return s.map((place, row) => pressAt(scene, experiment.parameters, { s: place, v: v[row]! }))
  }),
  ofExact: (state, { scene, state: { parameters } }) => pressAt(scene, parameters, state),
  text: (value) => `${value < 1000 ? fixed(value, 2) : plain(value)}${thin}m/s²`,
  least: 1,
  fromZero: true,
}

/** At a joint the block presses on what lies ahead of it. */
const AHEAD = 1e-9

function pressAt(scene: Scene, parameters: Parameters, { s, v }: Readonly<State>): number {
  const { slope, curvature } = scene.place(parameters, s + AHEAD * Math.sign(v))
  return Math.max(0, parameters.gravity! * Math.cos(slope) + curvature * v * v)
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

/** One of the plots: a quantity over time, or over another quantity. */
export interface PlotKind {
  readonly id: string
  readonly title: string
  /** What it shows, in a few words. */
  caption(simulated: Simulated): string
  /** Undefined: over time. */
  readonly over?: PlotQuantity
  readonly of: PlotQuantity
  /** Only for scenes with a track. */
  readonly onTrack?: true
  /** The exact block is not shown in it. */
  readonly isExactHidden?: true
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
    caption: energyCaption,
    of: energy,
  },
  {
    id: 'press',
    title: 'Press over position',
    caption: () => 'the normal force for each kilogram; 0 where a block takes off',
    over: position,
    of: press,
    onTrack: true,
  },
]

/** The same without the exact block, nor what is measured from it. */
const withoutExact: readonly PlotKind[] = plotKinds
  .filter(({ id }) => id !== 'error')
  .map((kind) => ({ ...kind, isExactHidden: true }))

/** The plots that make sense for a scene. */
export function plotsOf(
  { scene }: Pick<Simulated, 'scene'>,
  isExactHidden = false,
): readonly PlotKind[] {
  const kinds = isExactHidden ? withoutExact : plotKinds
  return kinds.filter(({ onTrack }) => !(onTrack && viewOf(scene).falls))
}

/** What the balance counts, by what there is in the scene. */
function energyCaption({ state: { parameters } }: Simulated): string {
  const heats = ['muKinetic' in parameters && 'friction', 'drag' in parameters && 'drag'].filter(
    Boolean,
  )
  return [
    `kinetic + potential${'stiffness' in parameters ? ', the spring’s too,' : ''} + heat of ${heats.join(' and ')}`,
    ...('beltSpeed' in parameters ? ['− work of the belt'] : []),
    '− what there was at the start; 0 is right',
  ].join(' ')
}
