import { cpus, release, type } from 'node:os'
import { integrators } from '../physics/index.ts'
import { inChild } from './child.ts'
import type { TaskName, Tasks } from './tasks.ts'
import { engineList, engines } from './engines/index.ts'
import { controlled } from './frontiers/controlled.ts'
import { compareAt } from './frontiers/compare.ts'
import { problems } from './frontiers/problems.ts'
import { frameTimes } from './frameTimes.ts'
import { handwritten } from './handwritten/index.ts'
import { engineClocks, engineScenes } from './engines/scenes.ts'
import type { Frontier, Report, WorkCurve, Machine } from './schema/index.ts'
import { targets } from './targets.ts'
import type { Care } from './timing/rounds.ts'

/** Said while it goes on. */
export type Tell = (what: string) => void

const careful: Care = { rounds: 41, atLeast: 1, warming: 60 }
const hasty: Care = { rounds: 3, atLeast: 0.5, warming: 5 }

/** A curve has two dozen points, whose neighbours bear them out: fewer rounds do. */
const forCurves = ({ rounds, atLeast, warming }: Care): Care => ({
  rounds: Math.ceil(rounds / 2),
  atLeast: atLeast / 4,
  warming: warming / 4,
})

/**
 * Measures everything, each in a process of its own, one after the other. What fails is noted as not run, and nothing
 * else suffers from it.
 *
 * @param quick few rounds, one method and one clock: to see that it works
 */
export async function measure(quick: boolean, tell: Tell): Promise<Omit<Report, 'diagrams'>> {
  const care = quick ? hasty : careful
  const notRun: Report['notRun'] = []

  async function attempt<N extends TaskName>(
    what: string,
    name: N,
    given: Parameters<Tasks[N]>[0],
  ): Promise<Awaited<ReturnType<Tasks[N]>> | undefined> {
    tell(what)
    try {
      return await inChild(name, given)
    } catch (error) {
      notRun.push({ what, why: error instanceof Error ? error.message : String(error) })
      return undefined
    }
  }

  const methods = integrators.filter(({ id }) => !quick || id === 'velocity-verlet')
  const loops = handwritten.filter(({ integrator }) => methods.some(({ id }) => id === integrator))
  const alone = []
  for (const { scene, integrator } of loops) {
    const given = { scene, integrator, care }
    alone.push(...((await attempt(`frames: ${scene}, ${integrator}`, 'alone', given)) ?? []))
  }
  const mixed = await attempt('frames: everything mixed', 'mixed', {
    methods: methods.map(({ id }) => id),
    care,
  })
  const frames = frameTimes(alone, mixed ?? [])

  const clocks = engineClocks.map(({ label }) => label).slice(0, quick ? 1 : undefined)
  const runs = (await attempt('runs: ours', 'ourRuns', { clocks })) ?? []
  const friction = []
  for (const { id: engine } of engines) {
    const found = await attempt(`runs: ${engine}`, 'engineRuns', { engine, clocks })
    if (found) {
      runs.push(...found.runs)
      friction.push(found.friction)
    }
  }
  const times = (await attempt('time of a step: engines', 'engineTimes', { care })) ?? []
  const recorded = await attempt('time of a frame: simulate', 'simulateTime', { care })
  const [first] = times
  if (first && recorded)
    times.splice(1, 0, { ...recorded, ratio: recorded.step.median / first.step.median })

  const frontiers: Frontier[] = []
  for (const { id: problem, label, about, experiment, at } of problems) {
    if (at.length === 0) continue
    const curves: WorkCurve[] = []
    for (const { id: method } of methods) {
      const given = { problem, method, care: forCurves(care) }
      const curve = await attempt(`speed against error: ${label}, ${method}`, 'curve', given)
      if (curve) curves.push(curve)
    }
    const what = `speed against error: ${label}, odex`
    const found = await attempt(what, 'odex', { problem, care: forCurves(care) })
    if (found) {
      curves.push(found.curve)
      if (found.failed.length > 0)
        notRun.push({
          what,
          why: `it gave up at the tolerances ${found.failed.map((each) => each.toExponential(1)).join(', ')}`,
        })
    }
    frontiers.push({
      id: problem,
      label,
      about,
      duration: experiment.duration,
      curves,
      at: at.map((error) => compareAt(curves, error)),
    })
  }

  const measured = {
    machine: machine(care.rounds, quick),
    engines: engineList(),
    frames,
    engineTests: {
      scenes: [...engineScenes],
      clocks,
      runs,
      times,
      friction,
    },
    frontiers,
    controlled: controlled(),
  }
  return { ...measured, targets: targets(measured), notRun }
}

/** What the figures were measured on. */
function machine(rounds: number, quick: boolean): Machine {
  const processors = cpus()
  return {
    date: new Date().toISOString(),
    processor: processors[0]?.model.trim() || 'unknown',
    cores: processors.length,
    system: `${type()} ${release()}`,
    node: process.versions.node,
    v8: process.versions.v8,
    rounds,
    quick,
  }
}
