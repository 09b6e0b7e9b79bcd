import * as physics from '../physics/index.ts'
import type { Described, IntegratorId, Options, Timestep } from '../physics/index.ts'
import { bareLoops, inFrames, inSeconds } from './bare/index.ts'
import type { BareLoop, Trial } from './bare/index.ts'
import type { StepTime, Timing } from './schema.ts'
import { bytesOf } from './timing/bytes.ts'
import { ratioOf, timeRounds, timingOf } from './timing/rounds.ts'
import type { Care, Work } from './timing/rounds.ts'

/** What one process finds out about a trial: beside the hand-written loop, either alone or after everything else. */
export interface TrialTimes {
  scene: string
  integrator: string
  trial: string
  bare: Timing
  ours: Timing
  recorded: Timing
  ratio: number
  recordedRatio: number
  bytes: number
}

/** A young generation of 64 MB holds what so many steps allocate, at a number or two each. */
const COUNTED_STEPS = 1e6

/** Our step on a trial, so many runs one after the other: they are made ready before the clock is looked at. */
export function steppingWork(trial: Trial, integrator: IntegratorId, many = 1): Work {
  const experiment = inSeconds(trial, integrator)
  const seconds = Math.round(trial.steps / trial.fps)
  const start = () => Array.from({ length: many }, () => physics.createRun(experiment))
  let runs = start()
  return {
    units: many * trial.steps,
    prepare: () => {
      runs = start()
    },
    run: () => {
      let sum = 0
      for (const run of runs) {
        for (let second = 0; second < seconds; second++) run.frame(1)
        sum += run.motion.s + run.motion.v + run.heat
      }
      return sum
    },
  }
}

/** `simulate` on a trial, which records every step as a frame. */
export function recordingWork(trial: Trial, integrator: IntegratorId): Work {
  const experiment = inFrames(trial, integrator)
  return {
    units: trial.steps,
    run: () => {
      const { s } = physics.simulate(experiment)
      return s[s.length - 1]!
    },
  }
}

/** Times one scene with one method, in a process that does nothing else. */
export function timeAlone(scene: string, integrator: string, care: Care): TrialTimes[] {
  return timeTrials(
    bareLoops.filter((loop) => loop.scene === scene && loop.integrator === integrator),
    care,
  )
}

/** Times every scene with these methods, in a process whose call sites have seen everything. */
export function timeMixed(methods: readonly string[], care: Care): TrialTimes[] {
  meetEverything(physics)
  return timeTrials(
    bareLoops.filter(({ integrator }) => methods.includes(integrator)),
    care,
  )
}

/** Runs all scenes, methods, rules and policies of a physics module, so that its call sites have seen them. */
export function meetEverything({
  createRun,
  integrators,
  scenes,
  simulate,
  stoppings,
  timesteps,
}: typeof physics): void {
  for (let round = 0; round < 3; round++)
    for (const { id: scene } of scenes)
      for (const { id: integrator } of integrators)
        for (const { id: stopping } of stoppings)
          for (const timestep of timesteps) {
            const method = { scene, integrator, stopping, timestep: initially(timestep) }
            simulate({ ...method, duration: 1 })
            const run = createRun(method)
            for (let frame = 0; frame < 60; frame++) run.frame(1 / 60)
          }
}

/** A policy with its options as the lab has them at first. */
function initially({ id, options }: Described & { options: Options }): Timestep {
  const values = Object.entries(options).map(([key, option]) => [key, option.initial])
  return { kind: id, ...Object.fromEntries(values) } as Timestep
}

function timeTrials(loops: readonly BareLoop[], care: Care): TrialTimes[] {
  const trials = loops.flatMap((loop) => loop.trials.map((trial) => ({ loop, trial })))
  const works = trials.flatMap(({ loop, trial }): Work[] => [
    {
      units: trial.steps,
      run: () => loop.run(trial.parameters, 1 / trial.fps, trial.steps),
    },
    steppingWork(trial, loop.integrator),
    recordingWork(trial, loop.integrator),
  ])
  const times = timeRounds(works, care)
  return trials.map(({ loop, trial }, i) => {
    const [bare, ours, recorded] = times.slice(3 * i, 3 * i + 3) as [number[], number[], number[]]
    return {
      scene: loop.scene,
      integrator: loop.integrator,
      trial: trial.kind,
      bare: timingOf(bare),
      ours: timingOf(ours),
      recorded: timingOf(recorded),
      ratio: ratioOf(ours, bare),
      recordedRatio: ratioOf(recorded, bare),
      bytes: bytesOf(steppingWork(trial, loop.integrator, Math.ceil(COUNTED_STEPS / trial.steps))),
    }
  })
}

/** Puts together what the two kinds of process found. */
export function stepTimes(alone: readonly TrialTimes[], mixed: readonly TrialTimes[]): StepTime[] {
  return alone.map((each) => {
    const { scene, integrator, trial, bare, recorded } = each
    const other = mixed.find(
      (row) => row.scene === scene && row.integrator === integrator && row.trial === trial,
    )
    return {
      scene,
      integrator,
      trial,
      bare,
      alone: each.ours,
      mixed: other?.ours ?? null,
      recorded,
      ratios: {
        alone: each.ratio,
        mixed: other?.ratio ?? null,
        recorded: each.recordedRatio,
      },
      bytes: { alone: each.bytes, mixed: other?.bytes ?? null },
    }
  })
}
