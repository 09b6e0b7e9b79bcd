import type { ReactiveController, ReactiveControllerHost } from 'lit'
import type { Preset } from './presets/preset.ts'
import { History } from './state/history.ts'
import type { LabState } from './state/state.ts'

/** What a lab showed, and the preset that it had come from. */
export interface Moment {
  readonly state: LabState
  readonly preset: Preset | undefined
  /** What was wrong with what was asked for, if it could not be run. */
  readonly problem: string
}

/** What can be brought back to a moment. */
interface Host extends ReactiveControllerHost, HTMLElement {
  restore(moment: Moment): void
}

/** Undo and redo of a lab, by method and by key. */
export class Past implements ReactiveController {
  private history: History<Moment> | undefined
  /** Since when a finger or a mouse button is down [ms]. */
  private heldSince: number | undefined
  private presses = 0
  /** The text field with something typed into it: keys undo the typing there. */
  private typedInto: EventTarget | null = null
  private readonly host: Host

  constructor(host: Host) {
    this.host = host
    host.addController(this)
    host.addEventListener('keydown', this.pressed)
    host.addEventListener('pointerdown', this.held)
    host.addEventListener('input', ({ target }) => {
      if ((target as Element).matches('textarea, input:not([type="range"])'))
        this.typedInto = target
    })
    for (const type of ['change', 'focusout'])
      host.addEventListener(type, () => (this.typedInto = null))
  }

  hostConnected(): void {
    addEventListener('pointerup', this.letGo)
    addEventListener('pointercancel', this.letGo)
  }

  hostDisconnected(): void {
    removeEventListener('pointerup', this.letGo)
    removeEventListener('pointercancel', this.letGo)
  }

  get canUndo(): boolean {
    return this.history?.canUndo ?? false
  }

  get canRedo(): boolean {
    return this.history?.canRedo ?? false
  }

  /**
   * Notes that the lab went from one moment to another.
   *
   * @param burst what the change is part of, by name, if it may be part of something: all of a drag is undone in one go
   */
  add(before: Moment, after: Moment, burst?: string): void {
    const now = this.heldSince ?? performance.now()
    const history = (this.history ??= new History(before))
    // It may have been set from outside in between.
    if (history.present.state !== before.state) history.add(before, undefined, now)
    history.add(after, burst && `${burst} ${this.presses}`, now)
  }

  undo(): void {
    this.go(this.history?.undo())
  }

  redo(): void {
    this.go(this.history?.redo())
  }

  private go(moment: Moment | undefined): void {
    if (moment) this.host.restore(moment)
  }

  private readonly held = (): void => {
    this.heldSince = performance.now()
    this.presses++
  }

  private readonly letGo = (): void => {
    this.heldSince = undefined
  }

  private readonly pressed = (event: KeyboardEvent): void => {
    const { ctrlKey, metaKey, altKey, shiftKey, target, defaultPrevented } = event
    if (defaultPrevented || altKey || ctrlKey === metaKey || target === this.typedInto) return
    const key = event.key.toLowerCase()
    const back = key === 'z' && !shiftKey
    const on = (key === 'z' && shiftKey) || (key === 'y' && ctrlKey && !shiftKey)
    if (!back && !on) return
    event.preventDefault()
    if (back) this.undo()
    else this.redo()
  }
}
