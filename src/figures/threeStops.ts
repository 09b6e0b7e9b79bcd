import type { Experiment } from '../physics/index.ts'
import { spreadOf } from '../measure/index.ts'
import { lengthText } from '../chart/numbers.ts'
import { modes } from '../lab/state/modes.ts'
import { spreadText } from '../lab/state/spreadText.ts'
import { figure } from './shared/figure.ts'
import { drawRuns } from './shared/scenePanel.ts'

const RATES = [10, 30, 120] as const
const names = RATES.map((fps) => `${fps} fps`)
const DURATION = 1

/** One kick at three frame rates. */
export const threeStops = figure({
  id: 'three-stops',
  title: 'One kick, three frame rates',
  pictured:
    'A block is kicked up a slope at 10, 30 and 120 frames a second; an outline shows the exact one.',
  controls: {
    mode: {
      type: 'choice',
      label: 'Stops',
      options: [
        { id: 'no-delta-time', label: 'No delta time' },
        { id: 'paper', label: 'The paper' },
        { id: 'clamped', label: 'Clamped' },
        { id: 'located', label: 'Located' },
      ],
      initial: 'clamped',
    },
  },
  experiments: ({ mode }): Experiment[] =>
    RATES.map((fps) => ({
      scene: 'ramp',
      parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
      ...modes.find(({ id }) => id === mode)!.method,
      frames: { kind: 'steady', fps },
      duration: DURATION,
    })),
  duration: () => DURATION,
  panels: [
    {
      shape: { wide: 0.52, narrow: 0.8 },
      draw: (surface, { runs, time }) => drawRuns(surface, runs, names, time),
    },
  ],
  says: ({ mode }, runs) => {
    const spread = spreadText(spreadOf(runs), lengthText).value
    return `${modes.find(({ id }) => id === mode)!.about} They end ${spread} apart.`
  },
})
