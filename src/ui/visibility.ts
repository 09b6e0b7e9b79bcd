type Seen = (isSeen: boolean) => void

/** One shared IntersectionObserver for all elements with the same margin. */
class Visibility {
  // Weak, since an element may watch itself for as long as it lives.
  private readonly listeners = new WeakMap<Element, Set<Seen>>()
  private made: IntersectionObserver | undefined

  constructor(private readonly rootMargin: string) {}

  /** Made when the first asks, since a server that imports the elements has no such thing. */
  private get observer(): IntersectionObserver {
    const { rootMargin } = this
    return (this.made ??= new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries)
          for (const listener of this.listeners.get(target) ?? []) listener(isIntersecting)
      },
      { rootMargin },
    ))
  }

  readonly watch = (element: Element, seen: Seen): (() => void) => {
    const listeners = this.listeners.get(element) ?? new Set()
    this.listeners.set(element, listeners.add(seen))
    // Observing again also notifies listeners that were added later.
    this.observer.unobserve(element)
    this.observer.observe(element)
    return () => {
      listeners.delete(seen)
      if (listeners.size > 0) return
      this.listeners.delete(element)
      this.observer.unobserve(element)
    }
  }
}

/** Calls back when an element enters the window and when it leaves. Returns a function that unsubscribes. */
export const onVisible = new Visibility('0px').watch

/** Like `onVisible`, from one window height above and below: time to prepare what will be seen. */
export const onNear = new Visibility('100% 0px').watch
