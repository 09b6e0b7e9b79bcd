import { onVisible } from '../../ui/visibility.ts'

/**
 * The phases of an update, in this order: drawing on a canvas, moving a part of the page, writing text. A font that is set
 * on a canvas after the page was changed makes the browser work out all of its styles.
 */
const phases = ['draw', 'move', 'write'] as const
export type UpdatePhase = (typeof phases)[number]

/** An element, and its listeners by phase. */
interface Subscriber {
  readonly listeners: Readonly<Record<UpdatePhase, Set<() => void>>>
  seen: boolean
  stopWatching: () => void
}

/** The subscribers of a moving instant. Each is notified while its element is visible. */
export class Subscribers {
  private readonly all = new Map<Element, Subscriber>()

  /** Returns a function that unsubscribes. */
  add(element: Element, phase: UpdatePhase, listener: () => void): () => void {
    const subscriber = this.all.get(element) ?? this.create(element)
    subscriber.listeners[phase].add(listener)
    return () => {
      subscriber.listeners[phase].delete(listener)
      if (phases.some((each) => subscriber.listeners[each].size > 0)) return
      this.all.delete(element)
      subscriber.stopWatching()
    }
  }

  private create(element: Element): Subscriber {
    const subscriber: Subscriber = {
      listeners: { draw: new Set(), move: new Set(), write: new Set() },
      seen: false,
      stopWatching: onVisible(element, (isSeen) => (subscriber.seen = isSeen)),
    }
    this.all.set(element, subscriber)
    return subscriber
  }

  /** Notifies everyone, or those that can be `seen`: of the instant, or only in the phases of `eachFrame`. */
  notify({ seen, eachFrame }: { readonly seen: boolean; readonly eachFrame: boolean }): void {
    for (const phase of phases) {
      if (eachFrame && phase === 'write') return
      for (const each of this.all.values())
        if (each.seen || !seen) for (const listener of each.listeners[phase]) listener()
    }
  }
}
