import { defaults, scenes } from '../../physics/index.ts'
import type { Parameters, Scene, SceneId } from '../../physics/index.ts'
import type { LabState, RunnerState } from './state.ts'

/** What shows at once what a scene is for, where its own defaults do not. */
const openings: { readonly [id in SceneId]?: { duration: number; parameters: Parameters } } = {
  fall: { duration: 2, parameters: { drag: 0.2 } },
  ramp: { duration: 1, parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 } },
  'run-out': { duration: 5, parameters: {} },
  'half-pipe': { duration: 6, parameters: { position: 2.8 } },
  spring: { duration: 4, parameters: { position: 1.5 } },
  // Just fast enough to take off where the top begins, at most frame rates.
  crest: { duration: 1.5, parameters: { speed: 6.9 } },
  belt: { duration: 5, parameters: { stiffness: 20, muStatic: 0.6, muKinetic: 0.2 } },
}

const runners: readonly RunnerState[] = [10, 30, 120].map((fps, paletteIndex) => ({
  frames: { kind: 'steady', fps },
  timestep: { kind: 'variable' },
  integrator: 'semi-implicit-euler',
  stopping: 'clamped',
  paletteIndex,
  hidden: false,
}))

/** The state in which a lab opens on a scene: three frame rates, and a picture that is already wrong. */
export function openingOf(id: SceneId): LabState {
  const scene: Scene = scenes.find((each) => each.id === id)!
  const initial = Object.entries(scene.parameters).map(([name, option]) => [name, option.initial])
  const { duration = scene.duration, parameters } = openings[id] ?? {}
  return {
    scene: id,
    parameters: { ...(Object.fromEntries(initial) as Parameters), ...parameters },
    duration,
    timeScale: defaults.timeScale,
    runners,
  }
}

/** The state in which a lab opens: a block is kicked up a ramp and stops at three places. */
export const opening: LabState = openingOf('ramp')
