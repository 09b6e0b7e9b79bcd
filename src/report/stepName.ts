import { integrators, scenes } from '../physics/index.ts'
import { entry } from '../physics/lists.ts'
import type { StepTime } from './schema.ts'

/** Which step is meant, as the page names its parts. */
export function stepName({
  scene,
  integrator,
  trial,
}: Pick<StepTime, 'scene' | 'integrator' | 'trial'>): string {
  const block = trial === 'stops' ? 'a block that stops' : 'a block that moves'
  return `${entry(scenes, scene).label}, ${entry(integrators, integrator).label}, ${block}`
}
