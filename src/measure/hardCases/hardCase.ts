import type { Experiment } from '../../physics/index.ts'

/** A case on which simulations go wrong: what it is and what to watch. */
export interface HardCase {
  readonly id: string
  /** Cases of one kind share a number, 1 … 17. */
  readonly group: number
  readonly label: string
  /** One sentence for whoever looks at it run. */
  readonly watch: string
  /** Runs to be seen side by side, at most eight. */
  readonly experiments: readonly Experiment[]
  /** Its experiments can't be run, and are refused with the reason. */
  readonly refused?: true
}
