import { html, nothing } from 'lit'
import { repeat } from 'lit/directives/repeat.js'
import { defaults, limits } from '../../physics/index.ts'
import type { Quantity } from '../../ui/quantityControl.ts'
import '../../ui/quantityControl.ts'
import { allowed } from '../../lab/labView.ts'
import type { LabView } from '../../lab/labView.ts'
import { openingOf } from '../../lab/state/opening.ts'

const durationQuantity: Quantity = {
  label: 'Duration',
  symbol: 'T',
  unit: 's',
  min: 0,
  max: limits.duration,
  slider: { from: 0.1, to: 20, step: 0.1 },
}

const timeScaleQuantity: Quantity = {
  label: 'Time scale',
  symbol: '',
  unit: '×',
  ...limits.timeScale,
  slider: { from: 0.05, to: 2, step: 0.05 },
}

/** What all runners share: the parameters of the scene, how long the run lasts, and how fast its time goes. */
export function parametersPanel({ simulated: { state, scene }, change, lesson }: LabView) {
  const start = openingOf(state.scene)
  const may = (name: string) => lesson?.may(name) !== false
  const parameters = Object.entries(scene.parameters).filter(([name]) => may(name))
  const count = parameters.length + (may('duration') ? 1 : 0) + (may('timeScale') ? 1 : 0)
  if (count === 0) return nothing
  const rows = Math.ceil(count / 2)
  return html`<section class="parameters" part="parameters">
    <h2>${scene.label}</h2>
    <div class="quantities" .style="--rows: ${rows}">
      ${repeat(
        parameters,
        ([name]) => `${scene.id} ${name}`,
        ([name, quantity]) =>
          html`<slide-quantity-control
            .quantity=${quantity}
            .value=${state.parameters[name]}
            .initial=${start.parameters[name]}
            .pick=${(value: unknown) => change({ kind: 'parameters', values: { [name]: value } })}
          ></slide-quantity-control>`,
      )}
      ${allowed(
        { lesson },
        'duration',
        html`<slide-quantity-control
          .quantity=${durationQuantity}
          .value=${state.duration}
          .initial=${start.duration}
          .pick=${(duration: unknown) => change({ kind: 'duration', duration })}
        ></slide-quantity-control>`,
      )}
      ${allowed(
        { lesson },
        'timeScale',
        html`<slide-quantity-control
          .quantity=${timeScaleQuantity}
          .value=${state.timeScale}
          .initial=${defaults.timeScale}
          .pick=${(timeScale: unknown) => change({ kind: 'timeScale', timeScale })}
        ></slide-quantity-control>`,
      )}
    </div>
  </section>`
}
