import { html, noChange } from 'lit'
import { live } from 'lit/directives/live.js'
import { fixed } from '../chart/numbers.ts'
import { icon } from '../ui/icons.ts'
import type { IconName } from '../ui/icons.ts'
import type { LabView } from './labView.ts'
import { atNow } from './playback/atNow.ts'

const speeds = [
  [1, '1×'],
  [1 / 2, '½×'],
  [1 / 4, '¼×'],
  [1 / 16, '¹⁄₁₆×'],
] as const

/** Playing, stepping, and the cursor on the time axis with every frame of every runner under it. */
export function transport({ simulated, playback }: LabView) {
  const { duration } = simulated.state
  const { playing } = playback
  const whole = clock(duration, duration)
  const shown = atNow(playback, (time) => clock(time, duration))
  const part = (time: number) => (duration > 0 ? time / duration : 1)
  return html`<div class="transport" part="transport">
    <div class="buttons">
      ${button('start', 'To the start (Home)', () => playback.toStart())}
      ${button('back', 'One frame back (←)', () => playback.stepFrames(-1))}
      <button
        type="button"
        class="play"
        title="${playing ? 'Pause' : 'Play'} (Space)"
        aria-label=${playing ? 'Pause' : 'Play'}
        @click=${() => playback.toggle()}
      >
        ${icon(playing ? 'pause' : 'play')}
      </button>
      ${button('on', 'One frame forward (→)', () => playback.stepFrames(1))}
      ${button('end', 'To the end (End)', () => playback.toEnd())}
    </div>
    <select
      aria-label="Playback speed"
      @change=${(event: Event) => {
        playback.speed = speeds[(event.target as HTMLSelectElement).selectedIndex]![0]
      }}
    >
      ${speeds.map(([, label]) => html`<option>${label}</option>`)}
    </select>
    <div class="axis ${playing ? 'moving' : ''}">
      <input
        type="range"
        aria-label="Time"
        aria-valuetext="${shown} of ${whole} seconds"
        min="0"
        max=${duration}
        step="any"
        .style="--filled: ${atNow(playback, (time) => (playback.playing ? noChange : part(time)))}"
        .value=${atNow(playback, (time) => live(String(time)))}
        @input=${(event: Event) => playback.seek((event.target as HTMLInputElement).valueAsNumber)}
      />
      <frame-strip
        .runners=${simulated.visible}
        .duration=${duration}
        .playback=${playback}
      ></frame-strip>
    </div>
    <p class="clock"><span .style="width: ${whole.length}ch">${shown}</span> / ${whole} s</p>
  </div>`
}

function button(name: IconName, label: string, act: () => void) {
  return html`<button
    type="button"
    title=${label}
    aria-label=${label.replace(/ \(.*/, '')}
    @click=${act}
  >
    ${icon(name)}
  </button>`
}

/** A time with as many decimals as the length of the run makes worth reading. */
function clock(time: number, duration: number): string {
  return fixed(time, duration < 0.1 ? 4 : duration < 100 ? 2 : 0)
}
