import { createRun } from '../physics/index.ts'
import { inFrames } from './bare/index.ts'
import type { BareLoop, Trial } from './bare/index.ts'
import type { Profile } from './schema.ts'
import { stepName } from './stepName.ts'
import { recordingWork, steppingWork } from './steps.ts'
import { median, timeRounds } from './timing/rounds.ts'
import type { Care, Work } from './timing/rounds.ts'

/** Columns of a recording. */
const COLUMNS = 6

/** What a frame of `simulate` costs, and which parts of that are the steps and the mere writing of its columns. */
export function recordingParts({ integrator }: BareLoop, trial: Trial, care: Care): Profile {
  const [recorded, stepped, written] = timed(
    [recordingWork(trial, integrator), steppingWork(trial, integrator), columns(trial)],
    care,
  )
  const what = `simulate, ${named(trial, integrator)}, ${recorded!.toFixed(1)} ns a frame`
  return parts(what, recorded!, [
    ['making six columns and writing a number a frame into each', written!],
    ['the steps', stepped!],
    ['reading the clock, heat, setting up', recorded! - written! - stepped!],
  ])
}

/** What a call of `run.frame` for each step costs, and how much of that it costs a block that lies still. */
export function frameParts({ integrator }: BareLoop, trial: Trial, care: Care): Profile {
  const still = { ...trial.parameters, angle: 0, speed: 0 }
  const [framed, idle, stepped] = timed(
    [
      framing(trial, integrator, trial.parameters),
      framing(trial, integrator, still),
      steppingWork(trial, integrator),
    ],
    care,
  )
  const what = `run.frame, ${named(trial, integrator)}, ${framed!.toFixed(1)} ns a call`
  return parts(what, framed!, [
    ['the same for a block that lies still', idle!],
    ['the step, as one of many', stepped!],
    ['calling the integrator for one step', framed! - idle! - stepped!],
  ])
}

const named = ({ scene, kind }: Trial, integrator: BareLoop['integrator']) =>
  stepName({ scene, integrator, trial: kind })

function timed(works: readonly Work[], care: Care): number[] {
  return timeRounds(works, care).map(median)
}

function parts(what: string, whole: number, times: [string, number][]): Profile {
  const functions = times.map(([name, time]) => ({ name, share: Math.max(0, time / whole) }))
  return { what, functions }
}

function columns({ steps }: Trial): Work {
  return {
    units: steps,
    run: () => {
      const made = Array.from({ length: COLUMNS }, () => new Float64Array(steps + 1))
      const [a, b, c, d, e, f] = made as [Float64Array, ...Float64Array[]]
      for (let row = 0; row <= steps; row++) {
        a[row] = row
        b![row] = row
        c![row] = row
        d![row] = row
        e![row] = row
        f![row] = row
      }
      return a[steps]! + f![steps]!
    },
  }
}

function framing(
  trial: Trial,
  integrator: BareLoop['integrator'],
  parameters: Trial['parameters'],
): Work {
  const experiment = { ...inFrames(trial, integrator), parameters }
  return {
    units: trial.steps,
    run: () => {
      const run = createRun(experiment)
      for (let i = 0; i < trial.steps; i++) run.frame(1 / trial.fps)
      return run.motion.s
    },
  }
}
