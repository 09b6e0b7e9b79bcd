import type { Experiment } from '../../physics/index.ts'

/** What an engine does with a frame by default, as far as a runner can do it. */
export interface Engine {
  readonly id: string
  readonly label: string
  readonly method: Readonly<Required<Pick<Experiment, 'timestep' | 'integrator' | 'stopping'>>>
  /** What it does by default, with its own names for what can be set. */
  readonly does: string
  /** What of it a runner does not do. */
  readonly leavesOut: string
  /** Where that stands, with the version. */
  readonly source: string
}
