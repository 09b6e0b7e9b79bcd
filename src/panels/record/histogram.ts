import { html, svg } from 'lit'
import { plain } from '../../chart/numbers.ts'
import { roundBelow } from '../../chart/ticks.ts'

/** As many bars as can be told apart. */
const MOST = 40
/** So many bars between 0 and the usual frame time, more or less. */
const FINENESS = 16

/** How many frame times lie in [from, to), in seconds. */
export interface Bin {
  readonly from: number
  /** Infinity in a last bin that holds all that are longer, too. */
  readonly to: number
  readonly count: number
}

/** Frame times [s] sorted into bins of a round width, from 0 on: as many as it takes, or as can be told apart. */
export function binsOf(durations: Iterable<number>, median: number): Bin[] {
  // In whole units of a hundredth of a millisecond, so that a time on an edge is on the right side of it.
  const unit = 1e5
  const width = Math.max(1, Math.round(roundBelow(median / FINENESS) * unit))
  const counts: number[] = []
  for (const duration of durations) {
    const bin = Math.min(MOST - 1, Math.floor(Math.round(duration * unit) / width))
    counts[bin] = (counts[bin] ?? 0) + 1
  }
  const edge = (i: number) => (i < MOST ? (i * width) / unit : Infinity)
  return Array.from(counts, (count = 0, i) => ({ from: edge(i), to: edge(i + 1), count }))
}

const HEIGHT = 96

/** Bars for frame times, and the same as a table. A bar that stands for a single frame is still seen. */
export function histogram(bins: readonly Bin[], label: string) {
  const most = Math.max(...bins.map(({ count }) => count))
  const milliseconds = (seconds: number) => plain(seconds * 1000)
  const filled = bins.filter(({ count }) => count > 0)
  const { from, to } = bins[bins.length - 1]!
  const end = Number.isFinite(to) ? `${milliseconds(to)} ms` : `${milliseconds(from)} ms and more`
  return html`<figure class="histogram">
    <svg
      viewBox="0 0 ${bins.length} ${HEIGHT}"
      preserveAspectRatio="none"
      role="img"
      aria-label=${label}
    >
      ${bins.map(({ count }, i) => {
        const height = count > 0 ? Math.max(3, (HEIGHT * count) / most) : 0
        return svg`<rect x=${i + 0.06} width="0.88" y=${HEIGHT - height} height=${height} />`
      })}
    </svg>
    <figcaption><span>0 ms</span><span>frame time</span><span>${end}</span></figcaption>
    <details>
      <summary>As a table</summary>
      <table>
        <thead>
          <tr>
            <th scope="col">Frame time [ms]</th>
            <th scope="col">Frames</th>
          </tr>
        </thead>
        <tbody>
          ${filled.map(
            ({ from, to, count }) =>
              html`<tr>
                <td>
                  ${milliseconds(from)}${Number.isFinite(to) ? `–${milliseconds(to)}` : ' and more'}
                </td>
                <td>${count}</td>
              </tr>`,
          )}
        </tbody>
      </table>
    </details>
  </figure>`
}
