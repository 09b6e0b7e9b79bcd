import { onSight } from './sight.ts'

/** An element, and what is to be done for it when the instant has moved. */
interface Onlooker {
  readonly draw: Set<() => void>
  readonly write: Set<() => void>
  seen: boolean
  stopWatching: () => void
}

/**
 * What follows a moving instant: each told of it as long as its element can be seen. Those that draw on a canvas come
 * before those that write to the page: a font that is set on a canvas after that has the browser work out all styles.
 */
export class Onlookers {
  private readonly all = new Map<Element, Onlooker>()

  /** Returns its undoing. */
  add(element: Element, does: 'draw' | 'write', listener: () => void): () => void {
    const known = this.all.get(element) ?? this.newcomer(element)
    known[does].add(listener)
    return () => {
      known[does].delete(listener)
      if (known.draw.size + known.write.size > 0) return
      this.all.delete(element)
      known.stopWatching()
    }
  }

  private newcomer(element: Element): Onlooker {
    const newcomer: Onlooker = {
      ...{ draw: new Set(), write: new Set(), seen: false },
      stopWatching: onSight(element, (isSeen) => (newcomer.seen = isSeen)),
    }
    this.all.set(element, newcomer)
    return newcomer
  }

  /** Those that can be seen, or `everyone`. */
  tell(everyone: boolean): void {
    for (const does of ['draw', 'write'] as const)
      for (const each of this.all.values())
        if (each.seen || everyone) for (const listener of each[does]) listener()
  }
}
