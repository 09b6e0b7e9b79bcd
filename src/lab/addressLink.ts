import type { ReactiveController, ReactiveControllerHost } from 'lit'
import { ExperimentError } from '../physics/index.ts'
import { isAddress, readAddress, writeAddress } from './state/address.ts'
import { opening } from './state/opening.ts'
import type { LabState } from './state/state.ts'

/** What keeps its state in the page's address. */
interface Linked extends ReactiveControllerHost {
  readonly state: LabState
  /** Takes over what an address said, or the opening and what was wrong with the address. */
  open(state: LabState, problem: string): void
}

/** Browsers refuse to have the address changed at every move of a finger: Safari allows 100 times in 30 s. */
const PAUSE = 400

/** Keeps a state and the part of the page's address after `#` the same. */
export class AddressLink implements ReactiveController {
  private address = ''
  private timer: ReturnType<typeof setTimeout> | undefined
  private readonly host: Linked

  constructor(host: Linked) {
    this.host = host
    host.addController(this)
  }

  hostConnected(): void {
    if (location.hash.includes('=')) this.read()
    else {
      // It may have been changed before it was linked.
      this.address = writeAddress(this.host.state)
      if (this.address) this.replace()
    }
    addEventListener('hashchange', this.read)
  }

  hostDisconnected(): void {
    removeEventListener('hashchange', this.read)
    clearTimeout(this.timer)
    this.timer = undefined
  }

  /** Writes a state into the address: at once, or soon if another was just written. */
  write(state: LabState): void {
    this.address = writeAddress(state)
    if (this.timer === undefined) this.replace()
  }

  /** Writes a state into an address of its own, so that the browser's Back leads to the one before. */
  push(state: LabState): void {
    clearTimeout(this.timer)
    this.replace()
    clearTimeout(this.timer)
    this.timer = undefined
    this.address = writeAddress(state)
    const { pathname, search, hash } = location
    if (hash === (this.address && `#${this.address}`)) return
    history.pushState(null, '', this.address ? `#${this.address}` : pathname + search)
  }

  private replace(): void {
    const { pathname, search, hash } = location
    const wanted = this.address && `#${this.address}`
    this.timer = undefined
    if (wanted === hash) return
    history.replaceState(history.state, '', wanted || pathname + search)
    this.timer = setTimeout(() => this.replace(), PAUSE)
  }

  private readonly read = (): void => {
    const address = location.hash.slice(1)
    if (!isAddress(address)) {
      // The name of a place in the page says nothing about the lab, which stays as it is.
      if (this.address) this.replace()
      return
    }
    this.address = address
    try {
      this.host.open(readAddress(address), '')
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      this.host.open(opening, error.message)
    }
  }
}
