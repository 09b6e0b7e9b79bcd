import type { Experiment } from '../../physics/index.ts'

/** A case on which simulations go wrong: what it is, what to watch, and what is promised of it. */
export interface HardCase {
  readonly id: string
  /** Cases of one kind share a number, 1 … 17. */
  readonly group: number
  readonly label: string
  /** One sentence for whoever looks at it run. */
  readonly watch: string
  /** What holds, in words; the tests hold it to figures. */
  readonly claim: string
  /** Runs to be seen side by side, at most eight. */
  readonly experiments: readonly Experiment[]
  /** Its experiments can't be run, and are refused with the reason. */
  readonly refused?: true
}
