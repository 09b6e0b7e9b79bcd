import { html, svg } from 'lit'
import { plain } from '../../chart/numbers.ts'
import type { Bin } from './bins.ts'

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
