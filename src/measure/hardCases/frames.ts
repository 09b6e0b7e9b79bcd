import type { Experiment, FramesChoice } from '../../physics/index.ts'
import type { HardCase } from './hardCase.ts'

const kick = (frames: FramesChoice): Experiment => ({
  scene: 'ramp',
  parameters: { angle: 20, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  frames,
  duration: 3,
})
const smooth: FramesChoice = { kind: 'steady', fps: 60 }
const beside = (frames: FramesChoice): Experiment[] => [
  kick(frames),
  { ...kick(frames), integrator: 'semi-implicit-euler', stopping: 'naive' },
  kick(smooth),
]
const resting = { angle: 10, muStatic: 0.5, muKinetic: 0.5 }
const spiral: Experiment = {
  scene: 'ramp',
  parameters: { speed: 1 },
  timestep: { kind: 'fixed', step: 0.001 },
  frames: { kind: 'recorded', durations: [2] },
  duration: 20,
}

/** Frames as they should not be. */
export const frames: readonly HardCase[] = [
  {
    id: 'half-second-hitch',
    group: 7,
    label: 'A hitch of half a second',
    watch: 'The block stops inside the long frame, and the paper’s step overshoots.',
    experiments: beside({ kind: 'hitch', fps: 60, every: 0.4, length: 0.5 }),
  },
  {
    id: 'five-fps',
    group: 7,
    label: 'Five frames a second',
    watch: 'Three frames to the stop, and yet the right place.',
    experiments: beside({ kind: 'steady', fps: 5 }),
  },
  {
    id: 'wild-jitter',
    group: 7,
    label: 'Jitter of 90 %',
    watch: 'Frames of 2 to 32 ms by chance: the path is the same.',
    experiments: beside({ kind: 'jitter', fps: 60, amount: 0.9, seed: 1 }),
  },
  {
    id: 'long-clock',
    group: 8,
    label: 'A clock that runs for hours',
    watch: 'The time after a million frames is their number over the frame rate, to the last bit.',
    experiments: [
      { scene: 'ramp', parameters: resting, frames: { kind: 'steady', fps: 60 }, duration: 16000 },
      { scene: 'ramp', parameters: resting, frames: { kind: 'steady', fps: 144 }, duration: 6900 },
    ],
  },
  {
    id: 'spiral-of-death',
    group: 17,
    label: 'The spiral of death',
    watch:
      'Each frame of 2 s asks for 2000 steps; with a bound of 50 the game runs late, and says by how much.',
    experiments: [spiral, { ...spiral, timestep: { kind: 'fixed', step: 0.001, maxSteps: 50 } }],
  },
]
