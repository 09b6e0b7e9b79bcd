import { html } from 'lit'
import { integrators, stoppings, timesteps } from '../../physics/index.ts'
import { REFERENCE_RATE } from '../../measure/index.ts'
import type { Method } from '../../measure/index.ts'
import { menu } from '../../ui/menu.ts'
import { segments } from '../../ui/segments.ts'
import { choose as chosenOf } from '../../lab/state/change.ts'
import { parametersOf } from './mapChoice.ts'
import type { MapChoice } from './mapChoice.ts'
import { progress } from './measuring.ts'
import type { Measuring } from './measuring.ts'

const shown = [
  { id: 'error', label: 'Error' },
  { id: 'spread', label: `Spread against ${REFERENCE_RATE} fps` },
] as const

/** What a map shows, to be chosen, and how far it is measured. */
export function mapControls(
  { experiment, of, parameter, method }: MapChoice,
  choose: (change: Partial<MapChoice>) => void,
  measuring: Measuring,
) {
  const set = (values: Partial<Method>) => {
    choose({ method: { ...method, ...values } })
    return true
  }
  const parameters = Object.entries(parametersOf(experiment)).map(([id, { label }]) => {
    return { id, label, about: `What runs upwards: ${label.toLowerCase()}` }
  })
  return html`<div class="measure-controls">
    ${segments({
      label: 'What the colours show',
      list: shown,
      chosen: of,
      pick: ({ id }) => choose({ of: id }),
    })}
    <label class="choose"
      >Frame rate ×
      ${menu({
        label: 'Parameter of the map',
        list: parameters,
        chosen: parameter,
        pick: (id) => {
          choose({ parameter: id })
          return true
        },
      })}
    </label>
    <span class="choose">
      ${menu({
        label: 'Integrator of the map',
        list: integrators,
        chosen: method.integrator,
        pick: (id) => set({ integrator: id }),
      })}
      ${menu({
        label: 'Stopping rule of the map',
        list: stoppings,
        chosen: method.stopping,
        pick: (id) => set({ stopping: id }),
      })}
      ${menu({
        label: 'Time step of the map',
        list: timesteps,
        chosen: method.timestep.kind,
        pick: (id) => set({ timestep: chosenOf('timestep', id, method.timestep) }),
      })}
    </span>
    ${progress(measuring)}
  </div>`
}
