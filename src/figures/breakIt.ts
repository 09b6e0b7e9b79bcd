import type { Experiment } from '../physics/index.ts'
import { spreadOf } from '../measure/index.ts'
import { lengthText } from '../chart/numbers.ts'
import { spreadText } from '../lab/state/spreadText.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import { drawRuns } from './shared/scenePanel.ts'

const DURATION = 2
/** Between one long frame and the next [s]. */
const EVERY = 0.3
const names = ['steady', 'scattered', 'stalling'] as const

/** The finished step under frames of three kinds, all set by the reader. */
export const breakIt = figure({
  id: 'break-it',
  title: 'Try to break it',
  pictured:
    'Three blocks kicked up a slope, under steady frames, scattered ones and stalling ones; an outline shows the exact one.',
  controls: {
    fps: rateControl(15, 2, 240),
    scatter: {
      type: 'number',
      label: 'Scatter',
      unit: '%',
      from: 0,
      to: 90,
      step: 5,
      initial: 60,
    },
    stall: {
      type: 'number',
      label: 'Stall',
      unit: 's',
      from: 0.05,
      to: 0.6,
      step: 0.05,
      initial: 0.25,
    },
    angle: {
      type: 'number',
      label: 'Angle',
      symbol: 'α',
      unit: '°',
      from: 0,
      to: 45,
      step: 1,
      initial: 15,
    },
  },
  experiments: ({ fps, scatter, stall, angle }): Experiment[] => {
    const kick = {
      scene: 'ramp',
      parameters: { angle, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
      duration: DURATION,
    } as const
    return [
      { ...kick, frames: { kind: 'steady', fps } },
      { ...kick, frames: { kind: 'jitter', fps, amount: scatter / 100, seed: 1 } },
      { ...kick, frames: { kind: 'hitch', fps, every: EVERY, length: stall } },
    ]
  },
  duration: () => DURATION,
  panels: [
    {
      shape: { wide: 0.52, narrow: 0.8 },
      draw: (surface, { runs, time }) => drawRuns(surface, runs, names, time),
    },
  ],
  says: (_, runs) => {
    const where = runs[0]!.outcome.kind === 'at-rest' ? 'They rest' : 'After 2 s they are'
    return `${where} ${spreadText(spreadOf(runs), lengthText).value} apart.`
  },
})
