import { count, plain, seconds } from '../../chart/numbers.ts'

/** What a simulated second costs. */
export interface CostKind {
  readonly id: 'evaluations' | 'time'
  readonly label: string
  /** What the axis says. */
  readonly axis: string
  readonly about: string
  readonly text: (cost: number) => string
  /** A cost in a sentence. */
  readonly inWords: (cost: number) => string
}

/** In which costs are counted, the first by default. */
export const costKinds: readonly CostKind[] = [
  {
    id: 'evaluations',
    label: 'Evaluations',
    axis: 'evaluations for a simulated second',
    about: 'How often the forces are worked out: the same on every device.',
    text: (cost) => (cost >= 1 && cost < 1e6 ? count(Math.round(cost)) : plain(cost)),
    inWords: (cost) => `${plain(cost)} evaluations a second`,
  },
  {
    id: 'time',
    label: 'Time on this device',
    axis: 'time for a simulated second',
    about:
      'Measured here and now, in a program that has used every method: a game that keeps to one takes less.',
    text: (cost) => seconds(cost * 1e-9),
    inWords: (cost) => `${seconds(cost * 1e-9)} for a simulated second`,
  },
]
