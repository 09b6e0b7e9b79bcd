import type { ExperimentError, Scene } from '../../physics/index.ts'
import type { Change } from './state.ts'

/** Why a change can't be made, in words for the place where it was tried. */
export function refusal({ problems }: ExperimentError, change: Change, scene: Scene): string {
  return problems
    .map(({ path, message }) => {
      const option = scene.parameters[path.replace('parameters.', '')]
      const isTheirs =
        change.kind === 'parameters' && path.replace('parameters.', '') in change.values
      return option && !isTheirs ? `${option.label}: ${message}` : message
    })
    .join(' ')
}
