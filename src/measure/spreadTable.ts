import { integrators, simulate } from '../physics/index.ts'
import type { Experiment, FramesChoice, ResolvedExperiment } from '../physics/index.ts'
import { spreadOf } from './spread.ts'
import type { Spread } from './spread.ts'

/** The frames under which a run must end in the same place to be called framerate-independent. */
export const spreadClocks: readonly FramesChoice[] = [
  ...[5, 10, 15, 24, 30, 60, 120, 144, 240].map((fps) => ({ kind: 'steady', fps }) as const),
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 1 },
  { kind: 'hitch', fps: 60, every: 0.7, length: 0.5 },
]

/**
 * The frame-rate spread: how far apart a run ends under different frames, all else equal.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function frameRateSpread(experiment: Experiment): Spread {
  return spreadOf(spreadClocks.map((frames) => simulate({ ...experiment, frames })))
}

/** A method: how frames become motion. */
export type Method = Readonly<Pick<ResolvedExperiment, 'timestep' | 'integrator' | 'stopping'>>

/** The paper's step, once a frame: the frame's length times the new velocity, with naive friction. */
export const paperMethod: Method = {
  integrator: 'semi-implicit-euler',
  stopping: 'naive',
  timestep: { kind: 'variable' },
}

/** The rows of the table: the paper's own step, then every integrator with one stopping rule and one timestep. */
export function spreadMethods({
  stopping,
  timestep,
}: Pick<Method, 'stopping' | 'timestep'>): readonly Method[] {
  return [paperMethod, ...integrators.map(({ id }) => ({ integrator: id, stopping, timestep }))]
}

/** Methods × experiments. */
export interface SpreadRequest {
  readonly methods: readonly Method[]
  /** A column each; their method and frames are replaced. */
  readonly experiments: readonly Experiment[]
}

/** The spreads of one method, one for each experiment. */
export interface SpreadRow {
  readonly row: number
  readonly spreads: readonly Spread[]
}

/**
 * Computes the table, row by row. It yields undefined between two cells, so that the caller can stop.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function* spreadTable({
  methods,
  experiments,
}: SpreadRequest): Generator<SpreadRow | undefined> {
  for (const [row, method] of methods.entries()) {
    const spreads: Spread[] = []
    for (const [column, experiment] of experiments.entries()) {
      spreads.push(frameRateSpread({ ...experiment, ...method } as Experiment))
      yield column === experiments.length - 1 ? { row, spreads } : undefined
    }
  }
}
