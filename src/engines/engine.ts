import type { Experiment, Timestep } from '../physics/index.ts'

/** What an engine does with a frame by default, as far as a runner can do it. */
export interface Engine {
  readonly id: string
  readonly label: string
  readonly method: Readonly<Required<Pick<Experiment, 'timestep' | 'integrator' | 'stopping'>>>
  /** What it does by default, with its own names for what can be set. */
  readonly does: string
  /** What of it a runner does not do. */
  readonly leavesOut: string
  /** What to change so that frames matter less, by the names of its settings, and the time step that follows. */
  readonly safer: { readonly how: string; readonly timestep: Timestep }
  /** Where that stands, with the version. */
  readonly source: string
}

/** The change where no setting helps: a loop of one's own, which makes a call for each step. */
export function ownLoop(call: string): Engine['safer'] {
  return {
    how: `Keep an accumulator of your own, and ${call} for each 1/60 s in it, at most 60 times a frame.`,
    timestep: { kind: 'fixed', step: 1 / 60, maxSteps: 60, draw: 'latest' },
  }
}
