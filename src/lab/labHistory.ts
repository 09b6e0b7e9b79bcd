import type { ReactiveController, ReactiveControllerHost } from 'lit'
import type { Preset } from './presets/preset.ts'
import { History } from './state/history.ts'
import type { LabState } from './state/state.ts'

/** What a lab showed, and the preset that it had come from. */
export interface Snapshot {
  readonly state: LabState
  readonly preset: Preset | undefined
  /** What was wrong with what was asked for, if it could not be run. */
  readonly problem: string
}

/** What can be brought back to a snapshot. */
interface Host extends ReactiveControllerHost, HTMLElement {
  restore(snapshot: Snapshot): void
}

/** Undo and redo of a lab, by method and by key. */
export class LabHistory implements ReactiveController {
  private states: History<Snapshot> | undefined
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
    return this.states?.canUndo ?? false
  }

  get canRedo(): boolean {
    return this.states?.canRedo ?? false
  }

  /**
   * Records that the lab went from one snapshot to another.
   *
   * @param group the undo group that the change belongs to, if it belongs to one: all of a drag is undone at once
   */
  add(before: Snapshot, after: Snapshot, group?: string): void {
    const now = this.heldSince ?? performance.now()
    const states = (this.states ??= new History(before))
    // It may have been set from outside in between.
    if (states.present.state !== before.state) states.add(before, undefined, now)
    states.add(after, group && `${group} ${this.presses}`, now)
  }

  undo(): void {
    this.go(this.states?.undo())
  }

  redo(): void {
    this.go(this.states?.redo())
  }

  private go(snapshot: Snapshot | undefined): void {
    if (snapshot) this.host.restore(snapshot)
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
