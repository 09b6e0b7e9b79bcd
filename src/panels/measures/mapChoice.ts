import { html } from 'lit'
import { scenes, integrators, stoppings, timesteps } from '../../physics/index.ts'
import type { Experiment, ResolvedExperiment, Scene } from '../../physics/index.ts'
import { REFERENCE_RATE } from '../../measure/index.ts'
import type { MapRequest, Method } from '../../measure/index.ts'
import { menu } from '../../ui/menu.ts'
import { segments } from '../../ui/segments.ts'
import { choose as chosenOf } from '../../lab/state/choose.ts'
import { sharedExperiment } from './sharedExperiment.ts'
import { progress } from './measuring.ts'
import type { Measuring } from './measuring.ts'

/** What the reader has chosen to see in a map. */
export interface MapChoice {
  /** The run whose scene it is of. */
  readonly experiment: ResolvedExperiment
  readonly of: MapRequest['of']
  /** What runs upwards. */
  readonly parameter: string
  readonly method: Method
}

const COLUMNS = 160
const ROWS = 120

/** What most of a scene depends on, where it is not its first parameter. */
const telling = ['stiffness', 'drag', 'radius', 'angle']

/** What can be set of the scene of a run, by name. */
export function parametersOf({ scene }: Pick<Experiment, 'scene'>): Scene['parameters'] {
  const { parameters }: Scene = scenes.find(({ id }) => id === scene)!
  return parameters
}

/** The parameter that the map of a run's scene is drawn over: the one that was chosen, where the scene has it. */
export function parameterFor(experiment: ResolvedExperiment, chosen: string): string {
  const names = Object.keys(parametersOf(experiment))
  return [chosen, ...telling].find((name) => names.includes(name)) ?? names[0]!
}

/** What is to be measured for it. */
export function mapRequest({ experiment, of, parameter, method }: MapChoice): MapRequest {
  const { slider, min } = parametersOf(experiment)[parameter]!
  return {
    experiment: { ...sharedExperiment(experiment as Experiment), ...method } as Experiment,
    of,
    parameter,
    from: Math.max(slider.from, min),
    to: slider.to,
    slowest: 5,
    fastest: 240,
    columns: COLUMNS,
    rows: ROWS,
  }
}

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
