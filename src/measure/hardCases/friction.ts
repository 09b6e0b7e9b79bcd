import type { Experiment } from '../../physics/index.ts'
import type { HardCase } from './hardCase.ts'

const uphill: Experiment = {
  scene: 'ramp',
  parameters: { angle: 20, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  duration: 3,
}
const flat: Experiment = { ...uphill, parameters: { ...uphill.parameters, angle: 0 } }
const between = { angle: 20, muStatic: 0.5, muKinetic: 0.2 }
/** tan 30°, rounded. */
const TAN_30 = 0.5773502691896257
const edge = (mu: number): Experiment => ({
  scene: 'ramp',
  parameters: { angle: 30, muStatic: mu, muKinetic: mu },
  duration: 3600,
})
const glue: Experiment = {
  scene: 'ramp',
  parameters: { angle: 20, muStatic: 1000, muKinetic: 1000, speed: -5 },
  frames: { kind: 'steady', fps: 1 },
  duration: 10,
}

const atRates = (experiment: Experiment): Experiment[] =>
  [5, 30, 144].map((fps) => ({ ...experiment, frames: { kind: 'steady', fps } }))
const byRules = (experiment: Experiment): Experiment[] =>
  (['located', 'clamped', 'naive'] as const).map((stopping) => ({ ...experiment, stopping }))

/** Stopping, staying, coming back: friction around v = 0. */
export const friction: readonly HardCase[] = [
  {
    id: 'stops-on-the-flat',
    group: 1,
    label: 'Stops on the flat, and stays',
    watch: 'All three stop at the same place at the same instant, in the middle of a frame.',
    experiments: atRates(flat),
  },
  {
    id: 'stops-uphill',
    group: 1,
    label: 'Stops uphill, and stays',
    watch: 'The three rules stop at three places, and the naive one trembles there for ever.',
    experiments: byRules({ ...uphill, frames: { kind: 'steady', fps: 10 } }),
  },
  {
    id: 'comes-back',
    group: 2,
    label: 'Stops uphill and comes back',
    watch: 'The instant of the turn lies inside a frame, and friction changes sides there.',
    experiments: atRates({
      scene: 'ramp',
      parameters: { angle: 35, muStatic: 0.3, muKinetic: 0.3, speed: -5 },
      duration: 3,
    }),
  },
  {
    id: 'held-or-sliding',
    group: 3,
    label: 'Steep enough to slide, not to set off',
    watch:
      'Put down it stays, pushed downhill it never stops, and pushed uphill it stops once and stays.',
    experiments: [0, 1, -1].map((speed) => ({
      scene: 'ramp',
      parameters: { ...between, speed },
      duration: 3,
    })),
  },
  {
    id: 'edge-of-holding',
    group: 4,
    label: 'The edge of holding, for an hour',
    watch:
      'One is held for ever, the other, with friction less by 2 parts in 10¹², creeps 0.03 mm.',
    experiments: [edge(TAN_30 * (1 + 1e-12)), edge(TAN_30 * (1 - 1e-12))],
  },
  {
    id: 'like-glue',
    group: 5,
    label: 'Friction of 1000, frames of a second',
    watch: 'The block should stop within 1.4 mm: naive friction throws it kilometres away instead.',
    experiments: byRules(glue),
  },
  {
    id: 'vertical-wall',
    group: 6,
    label: 'A vertical ramp',
    watch: 'Nothing presses the block to the wall, so friction does nothing and makes no heat.',
    experiments: [
      {
        scene: 'ramp',
        parameters: { angle: 90, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
        duration: 2,
      },
      { scene: 'fall', parameters: { speed: -5 }, duration: 2 },
    ],
  },
  {
    id: 'level-ramp',
    group: 6,
    label: 'A level ramp without friction',
    watch:
      'Nothing acts along it: at rest it stays, and moving it keeps its speed to the last bit.',
    experiments: [0, 3].map((speed) => ({
      scene: 'ramp',
      parameters: { angle: 0, muStatic: 0, muKinetic: 0, speed },
      duration: 10,
    })),
  },
]
