import { html } from 'lit'
import { icon } from '../../ui/icons.ts'
import type { IconName } from '../../ui/icons.ts'

interface Stepper {
  /** What is stepped through, in the singular. */
  readonly what: string
  /** The first and the last that there is. */
  readonly from: number
  readonly to: number
  readonly at: number
  readonly go: (to: number) => void
}

/** “Step 3 of 6” between buttons to the first, the one before, the next and the last. */
export function stepper({ what, from, to, at, go }: Stepper) {
  const button = (name: IconName, label: string, there: number) => {
    const isOff = there < from || there > to || there === at
    // Off for who uses it, not for the browser, which would take the focus away.
    return html`<button
      type="button"
      title=${label}
      aria-label="${label}, inside this step"
      aria-disabled=${isOff}
      @click=${() => isOff || go(there)}
    >
      ${icon(name)}
    </button>`
  }
  const name = what[0]!.toUpperCase() + what.slice(1)
  return html`<div class="stepper" role="group" aria-label="${name}s">
    ${button('start', `First ${what}`, from)} ${button('back', `Previous ${what}`, at - 1)}
    <span>${name} ${at - from + 1} of ${to - from + 1}</span>
    ${button('on', `Next ${what}`, at + 1)} ${button('end', `Last ${what}`, to)}
  </div>`
}
