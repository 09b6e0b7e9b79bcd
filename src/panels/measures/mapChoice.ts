import { scenes } from '../../physics/index.ts'
import type { Experiment, ResolvedExperiment, Scene } from '../../physics/index.ts'
import type { MapRequest, Method } from '../../measure/index.ts'
import { sharedExperiment } from './sharedExperiment.ts'

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
