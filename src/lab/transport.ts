import { html, noChange } from 'lit'
import { fixed } from '../chart/numbers.ts'
import { iconButton } from '../ui/icons.ts'
import type { LabView } from './labView.ts'
import { atNow } from './playback/atNow.ts'
import type { Playback } from './playback/playback.ts'

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
      ${iconButton('start', { label: 'To the start (Home)', act: () => playback.toStart() })}
      ${iconButton('back', { label: 'One frame back (←)', act: () => playback.stepFrames(-1) })}
      ${iconButton(playing ? 'pause' : 'play', {
        label: `${playing ? 'Pause' : 'Play'} (Space)`,
        act: () => playback.toggle(),
        className: 'play',
      })}
      ${iconButton('on', { label: 'One frame forward (→)', act: () => playback.stepFrames(1) })}
      ${iconButton('end', { label: 'To the end (End)', act: () => playback.toEnd() })}
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
        .value=${atNow(playback, String)}
        @input=${(event: Event) => playback.seek((event.target as HTMLInputElement).valueAsNumber)}
      />
      <slide-frame-strip
        .runners=${simulated.visible}
        .duration=${duration}
        .playback=${playback}
      ></slide-frame-strip>
    </div>
    <p class="clock"><span .style="width: ${whole.length}ch">${shown}</span> / ${whole} s</p>
  </div>`
}

/** A time with as many decimals as the length of the run makes worth reading. */
function clock(time: number, duration: number): string {
  return fixed(time, duration < 0.1 ? 4 : duration < 100 ? 2 : 0)
}

/** Fields and sliders have uses of their own for the keys, and a button is pressed with Space. */
const usesKeys = 'input, select, textarea, [role="slider"]'
const usesSpace = `${usesKeys}, button, a, summary`

/** Does what a key asks of the transport, unless what has the focus uses that key itself. */
export function shortcut(event: KeyboardEvent, playback: Playback): void {
  const { key, shiftKey } = event
  // Seen from outside a shadow root, the target is its host.
  const [target] = event.composedPath()
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return
  const acts: Readonly<Record<string, () => void>> = {
    ' ': () => playback.toggle(),
    ArrowLeft: () => playback.stepFrames(shiftKey ? -10 : -1),
    ArrowRight: () => playback.stepFrames(shiftKey ? 10 : 1),
    Home: () => playback.toStart(),
    End: () => playback.toEnd(),
  }
  const act = acts[key]
  if (!act || (target as Element).matches(key === ' ' ? usesSpace : usesKeys)) return
  event.preventDefault()
  act()
}
