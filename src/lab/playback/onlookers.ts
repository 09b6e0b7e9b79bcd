import { onSight } from '../../ui/sight.ts'

/**
 * What is done when the instant has moved, in this order: drawing on a canvas, moving a part of the page, writing. A font
 * that is set on a canvas after the page was changed has the browser work out all of its styles.
 */
const deeds = ['draw', 'move', 'write'] as const
export type Deed = (typeof deeds)[number]

/** An element, and what is to be done for it. */
interface Onlooker {
  readonly does: Readonly<Record<Deed, Set<() => void>>>
  seen: boolean
  stopWatching: () => void
}

/** What follows a moving instant: each told of it as long as its element can be seen. */
export class Onlookers {
  private readonly all = new Map<Element, Onlooker>()

  /** Returns its undoing. */
  add(element: Element, deed: Deed, listener: () => void): () => void {
    const known = this.all.get(element) ?? this.newcomer(element)
    known.does[deed].add(listener)
    return () => {
      known.does[deed].delete(listener)
      if (deeds.some((each) => known.does[each].size > 0)) return
      this.all.delete(element)
      known.stopWatching()
    }
  }

  private newcomer(element: Element): Onlooker {
    const newcomer: Onlooker = {
      does: { draw: new Set(), move: new Set(), write: new Set() },
      seen: false,
      stopWatching: onSight(element, (isSeen) => (newcomer.seen = isSeen)),
    }
    this.all.set(element, newcomer)
    return newcomer
  }

  /** Tells everyone, or those that can be `seen`: of the instant, or only what is to be done `eachFrame`. */
  tell({ seen, eachFrame }: { readonly seen: boolean; readonly eachFrame: boolean }): void {
    for (const deed of deeds) {
      if (eachFrame && deed === 'write') return
      for (const each of this.all.values())
        if (each.seen || !seen) for (const listener of each.does[deed]) listener()
    }
  }
}
