import type { IntegratorId } from '../physics/index.ts'
import { compareBundles } from './against/measure.ts'
import { engines } from './engines/index.ts'
import { engineRuns, engineTimes, ourRuns, simulateTime } from './engines/measure.ts'
import { timeAlone, timeMixed } from './frameTimes.ts'
import { ourCurve } from './frontiers/ours.ts'
import { odexCurve } from './frontiers/odex.ts'
import { problems } from './frontiers/problems.ts'
import type { Care } from './timing/rounds.ts'

/** What is measured in a process of its own, so that its call sites have seen nothing else. */
export const tasks = {
  against: compareBundles,

  alone: ({ scene, integrator, care }: { scene: string; integrator: string; care: Care }) =>
    timeAlone(scene, integrator, care),

  mixed: ({ methods, care }: { methods: string[]; care: Care }) => timeMixed(methods, care),

  ourRuns: ({ clocks }: { clocks: string[] }) => ourRuns(clocks),

  engineRuns: ({ engine, clocks }: { engine: string; clocks: string[] }) =>
    engineRuns(named(engines, engine), clocks),

  engineTimes: ({ care }: { care: Care }) => engineTimes(care),

  simulateTime: ({ care }: { care: Care }) => simulateTime(care),

  curve: ({ problem, method, care }: { problem: string; method: IntegratorId; care: Care }) =>
    ourCurve(named(problems, problem), method, care),

  odex: ({ problem, care }: { problem: string; care: Care }) =>
    odexCurve(named(problems, problem), care),
}

export type Tasks = typeof tasks
export type TaskName = keyof Tasks

function named<T extends { readonly id: string }>(list: readonly T[], id: string): T {
  return list.find((each) => each.id === id)!
}
