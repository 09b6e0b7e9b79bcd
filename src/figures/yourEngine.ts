import { exact as exactAt } from '../physics/index.ts'
import type { Experiment, FramesChoice, Trajectory } from '../physics/index.ts'
import { spreadOf } from '../measure/index.ts'
import { engines } from '../engines/index.ts'
import type { Engine } from '../engines/engine.ts'
import { lengthText, seconds } from '../chart/numbers.ts'
import { spreadText } from '../lab/state/spreadText.ts'
import { rateControl } from './shared/control.ts'
import { figure } from './shared/figure.ts'
import type { FigureReading } from './shared/figure.ts'
import { kick } from './shared/kick.ts'
import { roughly } from './shared/readings.ts'
import { drawRuns } from './shared/scenePanel.ts'

/** By then every block is at rest that had all of its time. */
const DURATION = 1.5
/** The frame rates of the players whose machines are quick enough. */
const QUICK = [60, 144]

interface EngineValues {
  readonly engine: string
  readonly settings: 'default' | 'safer'
  readonly clock: 'steady' | 'jitter' | 'missed-vsync' | 'hitch'
  readonly fps: number
}

/** The kick in the reader's own engine, on the machines of three players. */
export const yourEngine = figure({
  id: 'your-engine',
  title: 'Your engine, your players',
  pictured:
    'A block is kicked up a slope on three players’ machines, at three frame rates; an outline shows the exact one.',
  controls: {
    fps: { ...rateControl(20, 5, 50), label: 'Slowest player' },
    engine: {
      type: 'choice',
      label: 'Engine',
      options: engines.map(({ id, label }) => ({ id, label })),
      initial: 'unity-update',
      menu: true,
    },
    clock: {
      type: 'choice',
      label: 'Frames',
      options: [
        { id: 'steady', label: 'steady' },
        { id: 'jitter', label: 'jitter' },
        { id: 'missed-vsync', label: 'missed vsync' },
        { id: 'hitch', label: 'hitches of 0.4 s' },
      ],
      initial: 'steady',
    },
    settings: {
      type: 'choice',
      label: 'Settings',
      options: [
        { id: 'default', label: 'as they come' },
        { id: 'safer', label: 'on the safe side' },
      ],
      initial: 'default',
    },
  },
  experiments: (values): Experiment[] => {
    const { method, safer } = engineOf(values)
    const timestep = values.settings === 'safer' ? safer.timestep : method.timestep
    return ratesOf(values).map((fps) => ({
      ...kick,
      ...method,
      timestep,
      frames: clockOf(values.clock, fps),
      duration: DURATION,
    }))
  },
  duration: () => DURATION,
  panels: [
    {
      shape: { wide: 0.52, narrow: 0.8 },
      draw: (surface, { runs, values, time }) =>
        drawRuns(
          surface,
          runs,
          ratesOf(values).map((fps) => `${fps} fps`),
          time,
        ),
    },
  ],
  says: (values, runs) => {
    const { exact, value } = spreadText(spreadOf(runs), lengthText)
    const ends = exact ? 'in one place' : `${value} apart`
    const lost = Math.max(...runs.map(lostBy))
    const late = lost > 0 ? ` The slowest game loses ${seconds(lost)}.` : ''
    const settings = values.settings === 'safer' ? 'Changed' : 'As it comes'
    return `${settings}: the players’ blocks end ${ends}.${late}`
  },
  readings: (values, runs) =>
    runs.flatMap((run, i): FigureReading[] => {
      const rate = `${ratesOf(values)[i]!} fps`
      const off = Math.abs(run.drawnS[run.frames]! - exactAt(run.experiment, DURATION).s)
      const lost = lostBy(run)
      return [
        { label: `${rate}: off by`, text: roughly(off), raw: off },
        { label: `${rate}: time lost`, text: lostText(lost), raw: lost },
      ]
    }),
  advice: {
    text: (values) => adviceOn(engineOf(values)),
    longest: Math.max(...engines.map((engine) => adviceOn(engine).length)),
  },
})

function engineOf({ engine }: EngineValues): Engine {
  return engines.find(({ id }) => id === engine)!
}

function ratesOf({ fps }: EngineValues): readonly number[] {
  return [fps, ...QUICK]
}

function clockOf(kind: EngineValues['clock'], fps: number): FramesChoice {
  if (kind === 'steady') return { kind, fps }
  if (kind === 'jitter') return { kind, fps, amount: 0.7, seed: 3 }
  return kind === 'hitch' ? { kind, fps, every: 0.3, length: 0.4 } : { kind, fps, seed: 5 }
}

/** How far a game is behind the clock at the end [s], but for what waits for a step; negative if it is ahead. */
export function lostBy({ experiment, time, stateTime, frames, lostTime }: Trajectory): number {
  return experiment.timestep.kind === 'per-frame' ? time[frames]! - stateTime[frames]! : lostTime
}

function lostText(lost: number): string {
  // Steps of a frame add up to the clock but for rounding.
  if (Math.abs(lost) < 1e-9) return 'none'
  return lost > 0 ? seconds(lost) : `${seconds(-lost)} ahead`
}

function adviceOn({ does, safer, source }: Engine): string {
  const how = safer.how.charAt(0).toLowerCase() + safer.how.slice(1)
  return `${does} To be on the safe side: ${how} Source: ${source}.`
}
