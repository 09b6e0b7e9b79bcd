import { html, nothing } from 'lit'
import { live } from 'lit/directives/live.js'
import type { Trajectory } from '../../physics/index.ts'
import { fixed, raw } from '../../chart/numbers.ts'
import { icon } from '../../ui/icons.ts'
import { atNow, movedAtNow } from '../../lab/playback/atNow.ts'
import type { Playback } from '../../lab/playback/playback.ts'
import type { ControlValues } from '../shared/control.ts'
import type { Figure, View } from '../shared/figure.ts'
import { controlsOf } from './controls.ts'

/** What a live figure is made from. */
export interface Face {
  readonly figure: Figure
  readonly values: ControlValues
  readonly runs: readonly Trajectory[]
  readonly playback: Playback
  readonly spoken: string
  /** What takes the place of the pictures. */
  readonly hosted: HTMLElement | undefined
  readonly lit: string | undefined
  /** What readers may use, and which parts are kept from them. */
  readonly may: (control: string) => boolean
  readonly hides: (part: 'readings' | 'outcome') => boolean
  readonly set: (values: Readonly<Record<string, unknown>>) => void
}

/** A figure: its pictures, the controls below them, the outcome. */
export function face(shown: Face) {
  const { figure, values, runs, playback, spoken, hosted, hides } = shown
  const says = atNow(playback, (time) => figure.says(values, runs, time))
  return html`<div
      part="pictures"
      class="pictures ${hosted ? 'hosted' : ''}"
      @change=${hush}
      @input=${hush}
    >
      ${hosted ? withHeading(figure, hosted) : pictures(shown)}
    </div>
    <div class="below" @change=${hush} @input=${hush}>
      ${transportOf(shown)} ${controlsOf(shown)} ${hides('readings') ? nothing : readings(shown)}
      ${
        hides('outcome')
          ? nothing
          : html`<p class="says" part="outcome">${says}</p>
              ${figure.advice ? html`<p class="advice">${figure.advice.text(values)}</p>` : nothing}
              <p class="visually-hidden" aria-live="polite">${spoken}</p>`
      }
    </div>`
}

/** A hosted element has headings of its own, under one of the figure’s. */
function withHeading({ title }: Figure, hosted: HTMLElement) {
  return html`<h3 class="visually-hidden">${title}</h3>
    ${hosted}`
}

function pictures({ figure, values, runs, playback, lit, set, may }: Face) {
  const view = (time: number): View => ({ values, runs, time, lit })
  return figure.panels.map(
    (panel, i) =>
      html`<slide-figure-picture
        .panel=${panel}
        .controls=${figure.controls}
        .view=${view}
        .values=${values}
        .highlighted=${lit}
        .playback=${playback}
        .set=${set}
        .may=${may}
        .description=${i === 0 ? figure.pictured : ''}
      ></slide-figure-picture>`,
  )
}

/** Keeps a field's own event from leaving the figure. */
function hush(event: Event): void {
  event.stopPropagation()
}

function readings({ figure, values, runs, playback }: Face) {
  const { readings } = figure
  if (!readings) return nothing
  return html`<dl class="readings" part="readings">
    ${readings(values, runs, playback.time).map(({ label, raw: whole, colour }, i) => {
      const text = atNow(playback, (time) => readings(values, runs, time)[i]!.text)
      return html`<div>
        <dt>${label}</dt>
        <dd
          .style=${colour ? `color: var(${colour})` : ''}
          title=${whole === undefined ? nothing : raw(whole)}
        >
          ${text}
        </dd>
      </div>`
    })}
  </dl>`
}

/** Playing, and the cursor on time; the figure's own button, if it has one. */
function transportOf({ figure, values, playback, set }: Face) {
  const { action } = figure
  const duration = figure.duration?.(values)
  if (duration === undefined) return nothing
  const { playing } = playback
  const label = playing ? 'Pause' : 'Play'
  const act = () => {
    set({ ...action!.act(values, performance.now() / 1000) })
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
            <output>${atNow(playback, (time) => fixed(time, 2))}&#x202f;s</output>`
    }
  </div>`
}
