import type { Experiment, FramesChoice } from '../../physics/index.ts'
import type { HardCase, Claims } from './hardCase.ts'

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

const rough: Claims = {
  located: {
    what: 'Located stops, methods of second order and more: largest error',
    why: 'a rounding of 1.6 m in each of 180 steps',
    unit: 'm',
    rounding: true,
  },
  same: {
    what: 'The same: distance from where it ends at a steady 60 fps',
    why: 'the same roundings',
    unit: 'm',
    rounding: true,
  },
  euler: {
    what: 'Located stops, the two Euler methods: off at the end',
    why: '½ a Σ Δt², some centimetres at 60 fps already',
    unit: 'm',
    failure: 'stops in the wrong place',
  },
  paper: {
    what: 'The paper’s step: off at the end',
    why: 'it is of first order, and its stops are naive',
    unit: 'm',
    failure: 'ends elsewhere, and never rests',
  },
}

/** What holds of the cases of frames and clocks. */
export const framesClaims: Readonly<Record<string, Claims>> = {
  'half-second-hitch': rough,
  'five-fps': rough,
  'wild-jitter': rough,
  'long-clock': {
    run: {
      what: 'A run of a million frames: how far its clock is off at any of them',
      why: 'frames are counted, and their number divided by the rate once',
      unit: 's',
    },
    clock: {
      what: 'The clock after ten million frames: off by',
      why: 'the same',
      unit: 's',
    },
    loop: {
      what: 'A game’s loop that adds ten million frame times: off by',
      why: 'one rounding of the sum',
      unit: 's',
      rounding: true,
    },
  },
  'spiral-of-death': {
    whole: {
      what: 'Without a bound: steps in 20 s',
      why: '20 s in steps of a millisecond',
      unit: 'things',
    },
    steps: {
      what: 'With a bound: steps a frame',
      why: 'the bound',
      unit: 'things',
    },
    lost: {
      what: 'The same: time dropped, as reported',
      why: '1950 steps of a millisecond in each of ten frames',
      unit: 's',
    },
    same: {
      what: 'The same: distance from the run without a bound after as many steps',
      why: 'the same steps, so the same bits',
      unit: 'm',
    },
  },
}
