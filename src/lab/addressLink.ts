import type { ReactiveController, ReactiveControllerHost } from 'lit'
import { ExperimentError } from '../physics/index.ts'
import { lessonOf, splitAddress } from './lesson.ts'
import type { Lesson } from './lesson.ts'
import { refusalNotice } from './notices.ts'
import { isAddress, isReadable, readAddress, writeAddress } from './state/address.ts'
import { checked } from './state/check.ts'
import type { Draft } from './state/check.ts'
import { opening } from './state/opening.ts'
import type { LabState } from './state/state.ts'

/** What keeps its state in the page's address. */
interface Linked extends ReactiveControllerHost {
  readonly state: LabState
  /** What the address lets readers use and see. */
  lesson: Lesson | undefined
  /** Takes over what an address said, or the opening and, after a sentence, what was wrong with the address. */
  open(state: LabState, problem: string): void
}

/** Browsers refuse to have the address changed at every move of a finger: Safari allows 100 times in 30 s. */
const PAUSE = 400

const REFUSED = 'This link asks for something that can’t be run. The lab shows its opening instead.'

/** What the browser keeps with an address. */
interface Kept {
  /** A lab's state that is too long for an address. */
  readonly lab?: LabState
}

/**
 * Keeps a state and the part of the page's address after `#` the same. A state that is too long for an address, such as one
 * with thousands of recorded frames, is kept by the browser beside the address: a reload brings it back.
 */
export class AddressLink implements ReactiveController {
  private address = ''
  /** What of the address is about a lesson: it stays whatever readers do. */
  private lesson = ''
  private kept: Kept | null = null
  private timer: ReturnType<typeof setTimeout> | undefined
  private readonly host: Linked

  constructor(host: Linked) {
    this.host = host
    host.addController(this)
  }

  hostConnected(): void {
    if (location.hash.includes('=') || keptLab()) this.read()
    else {
      // It may have been changed before it was linked.
      this.set(this.host.state)
      if (this.address || this.kept) this.replace()
    }
    addEventListener('hashchange', this.read)
  }

  hostDisconnected(): void {
    removeEventListener('hashchange', this.read)
    clearTimeout(this.timer)
    this.timer = undefined
  }

  /** What the page shows of an address that can’t be run: of a lab with an address it may be needed before its panels are. */
  readonly refusal = refusalNotice

  /** Writes a state into the address: at once, or soon if another was just written. */
  write(state: LabState): void {
    this.set(state)
    if (this.timer === undefined) this.replace()
  }

  /** Writes a state into an address of its own, so that the browser's Back leads to the one before. */
  push(state: LabState): void {
    clearTimeout(this.timer)
    this.replace()
    clearTimeout(this.timer)
    this.timer = undefined
    this.set(state)
    const { pathname, search, hash } = location
    if (!this.kept && hash === (this.address && `#${this.address}`)) return
    history.pushState(this.kept, '', this.address ? `#${this.address}` : pathname + search)
  }

  private set(state: LabState): void {
    const address = [writeAddress(state), this.lesson].filter(Boolean).join('&')
    const isShort = isReadable(address)
    this.address = isShort ? address : this.lesson
    this.kept = isShort ? null : { lab: state }
  }

  private replace(): void {
    const { pathname, search, hash } = location
    const wanted = this.address && `#${this.address}`
    this.timer = undefined
    if (wanted === hash && !this.kept && !keptLab()) return
    history.replaceState(this.kept, '', wanted || pathname + search)
    this.timer = setTimeout(() => this.replace(), PAUSE)
  }

  private readonly read = (): void => {
    const address = location.hash.slice(1)
    if (!isAddress(address)) {
      // The name of a place in the page says nothing about the lab, which stays as it is.
      if (this.address) this.replace()
      return
    }
    const lab = keptLab()
    const { said, rest, asked } = splitAddress(address)
    this.address = address
    this.lesson = said
    this.kept = lab ? { lab } : null
    try {
      const { lesson, problems } = lessonOf(asked)
      this.host.lesson = lesson
      if (problems.length > 0) throw new ExperimentError(problems)
      this.host.open(lab ? checked(lab as Draft) : readAddress(rest), '')
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      this.host.open(opening, `${REFUSED}\n${error.message}`)
    }
  }
}

/** The state that the browser keeps beside the address: one that is said in the address goes before it. */
function keptLab(): LabState | undefined {
  if (splitAddress(location.hash.slice(1)).rest.includes('=')) return undefined
  return (history.state as Kept | null)?.lab
}
