import { html } from 'lit'
import type { Report } from '../../../report/schema.ts'

/** Where and when it was measured. */
export function machineLine({ machine }: Report) {
  const { date, processor, cores, system, node, rounds, quick } = machine
  const day = new Date(date).toLocaleDateString('en', {
    year: 'numeric',
    month: 'long',
    day: 'numeric',
    timeZone: 'UTC',
  })
  return html`<p class="soft">
    Measured on ${day}: ${processor}, ${cores} cores, ${system}, Node ${node}; each time is the
    median of ${rounds} interleaved
    rounds.${quick ? ' A quick look with few and short rounds.' : ''}
  </p>`
}
