import { html, nothing } from 'lit'
import { live } from 'lit/directives/live.js'
import { fixed } from '../../chart/numbers.ts'
import { atNow, movedAtNow } from '../../lab/playback/atNow.ts'
import { icon } from '../../ui/icons.ts'
import type { Face } from './face.ts'

/** Playing, and the cursor on time; the figure's own button, if it has one. */
export function transportOf({ figure, values, playback, set }: Face) {
  const { action } = figure
  const duration = figure.duration?.(values)
  if (duration === undefined) return nothing
  const { playing } = playback
  const label = playing ? 'Pause' : 'Play'
  const act = () => {
    set({ ...action!.act(values) })
    playback.toStart()
    playback.play()
  }
  return html`<div class="transport-line" part="transport">
    ${
      action
        ? html`<button type="button" class="act" @click=${act}>${action.label(values)}</button>`
        : nothing
    }
    ${
      duration === 0
        ? nothing
        : html`<button
              type="button"
              class="play"
              title=${label}
              aria-label=${label}
              @click=${() => playback.toggle()}
            >
              ${icon(playing ? 'pause' : 'play')}
            </button>
            <input
              type="range"
              aria-label="Time"
              aria-valuetext="${atNow(playback, (time) => fixed(time, 2))} of ${fixed(duration, 2)} seconds"
              min="0"
              max=${duration}
              step="any"
              .style="--filled: ${movedAtNow(playback, (time) => time / duration)}"
              .value=${movedAtNow(playback, (time) => live(String(time)))}
              @input=${(event: Event) =>
                playback.seek((event.target as HTMLInputElement).valueAsNumber)}
            />
            <output>${atNow(playback, (time) => fixed(time, 2))}&thinsp;s</output>`
    }
  </div>`
}
