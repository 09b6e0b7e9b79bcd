import type { IntegratorId } from '../physics/index.ts'
import * as physics from '../physics/index.ts'
import { compareModules } from './against/measure.ts'
import { bareLoops } from './bare/index.ts'
import { frameParts, recordingParts } from './breakdown.ts'
import { ourCurve } from './frontiers/ours.ts'
import { odexCurve } from './frontiers/odex.ts'
import { problems } from './frontiers/problems.ts'
import { peers } from './peers/index.ts'
import { frameTime, ourRuns, peerRuns, peerTimes } from './peers/measure.ts'
import { profileOf } from './profile.ts'
import { stepName } from './stepName.ts'
import { meetEverything, steppingWork, timeAlone, timeMixed } from './steps.ts'
import type { Care } from './timing/rounds.ts'

/** What is measured in a process of its own, so that its call sites have seen nothing else. */
export const tasks = {
  against: compareModules,

  alone: ({ scene, integrator, care }: { scene: string; integrator: string; care: Care }) =>
    timeAlone(scene, integrator, care),

  mixed: ({ methods, care }: { methods: string[]; care: Care }) => timeMixed(methods, care),

  ourRuns: ({ clocks }: { clocks: string[] }) => ourRuns(clocks),

  peerRuns: ({ peer, clocks }: { peer: string; clocks: string[] }) =>
    peerRuns(named(peers, peer), clocks),

  peerTimes: ({ care }: { care: Care }) => peerTimes(care),

  frameTime: ({ care }: { care: Care }) => frameTime(care),

  curve: ({ problem, method, care }: { problem: string; method: IntegratorId; care: Care }) =>
    ourCurve(named(problems, problem), method, care),

  odex: ({ problem, care }: { problem: string; care: Care }) =>
    odexCurve(named(problems, problem), care),

  recordingParts: ({ care, ...profiled }: Profiled & { care: Care }) => {
    const { loop, timed } = trialOf(profiled)
    return recordingParts(loop, timed, care)
  },

  frameParts: ({ care, ...profiled }: Profiled & { care: Care }) => {
    const { loop, timed } = trialOf(profiled)
    return frameParts(loop, timed, care)
  },

  profile: (profiled: Profiled) => {
    const { scene, integrator, trial, mixed } = profiled
    if (mixed) meetEverything(physics)
    const { loop, timed } = trialOf(profiled)
    const what = `${stepName({ scene, integrator, trial })}, ${mixed ? 'mixed' : 'alone'}`
    return profileOf(what, steppingWork(timed, loop.integrator))
  },
}

/** A scene and method whose time is to be looked into. */
export interface Profiled {
  scene: string
  integrator: string
  trial: string
  mixed: boolean
}

function trialOf({ scene, integrator, trial }: Profiled) {
  const loop = bareLoops.find((each) => each.scene === scene && each.integrator === integrator)!
  return { loop, timed: loop.trials.find(({ kind }) => kind === trial)! }
}

export type Tasks = typeof tasks
export type TaskName = keyof Tasks

function named<T extends { readonly id: string }>(list: readonly T[], id: string): T {
  return list.find((each) => each.id === id)!
}
