import type { Change } from './change.ts'

/** States in the order they came, with a place among them: undo and redo. */
export class History<State> {
  private states: State[]
  private place = 0
  private burst: string | undefined
  private burstEnds = 0

  constructor(first: State) {
    this.states = [first]
  }

  /** Where it stands. */
  get present(): State {
    return this.states[this.place]!
  }

  get canUndo(): boolean {
    return this.place > 0
  }

  get canRedo(): boolean {
    return this.place < this.states.length - 1
  }

  /**
   * Puts a state after the present one; what had been undone is forgotten. States of one burst (a drag, a number being
   * typed) follow each other closely and are undone in one go.
   *
   * @param burst what the change belongs to, by name; undefined: nothing but itself
   * @param now when it was made [ms]
   */
  add(state: State, burst: string | undefined, now: number): void {
    const isSame = burst !== undefined && burst === this.burst
    const goesOn = isSame && now < this.burstEnds && this.place > 0
    this.burst = burst
    this.burstEnds = now + BURST
    this.states.length = this.place + 1
    if (goesOn) this.states[this.place] = state
    else if (this.states.push(state) > MOST_KEPT) this.states.shift()
    this.place = this.states.length - 1
  }

  /** Goes one state back, or on; returns it, or undefined where there is none. */
  undo(): State | undefined {
    return this.go(-1)
  }

  redo(): State | undefined {
    return this.go(1)
  }

  private go(by: -1 | 1): State | undefined {
    this.burst = undefined
    const state = this.states[this.place + by]
    if (state !== undefined) this.place += by
    return state
  }
}

/** Changes that follow each other within this time belong together [ms]. */
const BURST = 700

const MOST_KEPT = 200

/**
 * The name of what a change may be part of: the dragging of a handle or a slider, the stepping of a number. Choices
 * stand for themselves.
 */
export function burstOf(change: Change): string | undefined {
  switch (change.kind) {
    case 'parameters':
      return Object.keys(change.values).join(' ')
    case 'duration':
      return 'duration'
    case 'option':
      return `${change.index} ${change.of} ${change.key}`
    default:
      return undefined
  }
}
