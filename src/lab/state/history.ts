import type { Change } from './change.ts'

/** States in the order they came, with a place among them: undo and redo. */
export class History<State> {
  private states: State[]
  private place = 0
  private group: string | undefined
  private groupEnds = 0

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
   * Puts a state after the present one; what had been undone is forgotten. States of one group (a drag, a number being
   * typed) follow each other closely and are undone in one go.
   *
   * @param group the undo group that the change belongs to, by name; undefined: a group of its own
   * @param now when it was made [ms]
   */
  add(state: State, group: string | undefined, now: number): void {
    const isSame = group !== undefined && group === this.group
    const continues = isSame && now < this.groupEnds && this.place > 0
    this.group = group
    this.groupEnds = now + GROUP_PAUSE
    this.states.length = this.place + 1
    if (continues) this.states[this.place] = state
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
    this.group = undefined
    const state = this.states[this.place + by]
    if (state !== undefined) this.place += by
    return state
  }
}

/** Changes that follow each other within this time belong together [ms]. */
const GROUP_PAUSE = 700

const MOST_KEPT = 200

/**
 * The undo group that a change belongs to: the dragging of a handle or a slider, the stepping of a number. Choices
 * stand for themselves.
 */
export function undoGroupOf(change: Change): string | undefined {
  switch (change.kind) {
    case 'parameters':
      return Object.keys(change.values).join(' ')
    case 'duration':
    case 'timeScale':
      return change.kind
    case 'option':
      return `${change.index} ${change.of} ${change.key}`
    default:
      return undefined
  }
}
