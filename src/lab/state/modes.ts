import type { Method } from '../../measure/index.ts'
import type { LabState } from './state.ts'

/** A way of moving blocks that all runners can be set to at once. */
interface Mode {
  readonly id: string
  readonly label: string
  /** What it does and what to look for. */
  readonly about: string
  /** The same where there is no friction and so nothing stops. */
  readonly withoutFriction?: string
  readonly method: Method
}

const step = 1 / 60

/** From the oldest mistake to the cure, each mending one thing of the one before. */
export const modes = [
  {
    id: 'no-delta-time',
    label: 'No delta time',
    about:
      'Every frame moves the block by 1/60 s, however long the frame was. At 10 fps the game runs six times too slowly, at 120 fps twice too fast.',
    method: {
      timestep: { kind: 'per-frame', step },
      integrator: 'semi-implicit-euler',
      stopping: 'clamped',
    },
  },
  {
    id: 'paper',
    label: 'The paper',
    about:
      'Velocity, then position, each times deltaTime; friction against the velocity, whatever it is. The stops differ, and a block that should rest trembles on the spot for ever.',
    withoutFriction:
      'Velocity, then position, each times deltaTime. The fewer the frames, the further the block is from where it should be.',
    method: {
      timestep: { kind: 'variable' },
      integrator: 'semi-implicit-euler',
      stopping: 'naive',
    },
  },
  {
    id: 'clamped',
    label: 'Clamped',
    about:
      'The paper’s step, but one that would turn the velocity round ends at rest. Nothing trembles any more; still every frame rate has a stopping place of its own.',
    withoutFriction:
      'The paper’s step with stops mended. Without friction nothing stops, so nothing changes: every frame rate still ends at a place of its own.',
    method: {
      timestep: { kind: 'variable' },
      integrator: 'semi-implicit-euler',
      stopping: 'clamped',
    },
  },
  {
    id: 'fixed-step',
    label: 'Fixed step',
    about:
      'Physics takes steps of 1/60 s whatever the frames do, and the picture is drawn between two of them. Every frame rate agrees: a step late, and all on the same wrong place.',
    method: {
      timestep: { kind: 'fixed', step, maxSteps: 100000, cap: 60, draw: 'interpolated' },
      integrator: 'semi-implicit-euler',
      stopping: 'clamped',
    },
  },
  {
    id: 'located',
    label: 'Located',
    about:
      'Steps along parabolas and finds the instant of each stop. Where the force is constant all frame rates agree to the last digit; where it changes, fewer frames end further off.',
    withoutFriction:
      'Steps along parabolas. Where the force is constant all frame rates agree with the exact block, to the last digit; where it changes, fewer frames end further off.',
    method: {
      timestep: { kind: 'variable' },
      integrator: 'velocity-verlet',
      stopping: 'located',
    },
  },
  {
    id: 'to-tolerance',
    label: 'To tolerance',
    about:
      'As many steps in each frame as an error of a micrometre a second asks for, and shorter ones where the motion is quick. Wherever the motion allows it, all frame rates agree.',
    method: {
      timestep: { kind: 'tolerance', tolerance: 1e-6 },
      integrator: 'rk4',
      stopping: 'located',
    },
  },
] as const satisfies readonly Mode[]

export type ModeId = (typeof modes)[number]['id']

/** The mode that every runner is in, if there is one. */
export function modeOf(state: LabState): (typeof modes)[number] | undefined {
  return modes.find(({ method }) => state.runners.every((runner) => sameMethod(runner, method)))
}

/** What a mode does in a scene, by whether there is friction. */
export function aboutOf(
  { about, withoutFriction }: Mode,
  { parameters: { muStatic = 0, muKinetic = 0 } }: Pick<LabState, 'parameters'>,
): string {
  return muStatic > 0 || muKinetic > 0 ? about : (withoutFriction ?? about)
}

/** Whether two blocks are moved the same way, whatever their frames. */
export function sameMethod(a: Method, b: Method): boolean {
  return (
    a.integrator === b.integrator &&
    a.stopping === b.stopping &&
    sameValues({ ...a.timestep }, { ...b.timestep })
  )
}

function sameValues(a: Record<string, unknown>, b: Record<string, unknown>): boolean {
  const keys = Object.keys(a)
  return keys.length === Object.keys(b).length && keys.every((key) => a[key] === b[key])
}
