import { integrators } from '../physics/index.ts'
import { bareLoops } from './bare/index.ts'
import { inChild } from './child.ts'
import type { TaskName, Tasks } from './tasks.ts'
import { contestants } from './contestants.ts'
import { compareAt } from './frontiers/compare.ts'
import { problems } from './frontiers/problems.ts'
import { machine } from './machine.ts'
import { peers } from './peers/index.ts'
import { peerClocks, peerScenes } from './peers/scenes.ts'
import type { Frontier, Report, WorkCurve } from './schema.ts'
import { stepTimes } from './steps.ts'
import { targets, worthProfiling, worthTakingApart } from './targets.ts'
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
 * @param quick few rounds, one method, one clock and no profiles: to see that it works
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
  const loops = bareLoops.filter(({ integrator }) => methods.some(({ id }) => id === integrator))
  for (const { id, label } of methods)
    if (!loops.some(({ integrator }) => integrator === id))
      notRun.push({
        what: `steps: ${label}`,
        why: 'nobody has written a loop by hand to compare it with',
      })
  const alone = []
  for (const { scene, integrator } of loops) {
    const given = { scene, integrator, care }
    alone.push(...((await attempt(`steps: ${scene}, ${integrator}`, 'alone', given)) ?? []))
  }
  const mixed = await attempt('steps: everything mixed', 'mixed', {
    methods: methods.map(({ id }) => id),
    care,
  })
  const steps = stepTimes(alone, mixed ?? [])

  const clocks = peerClocks.map(({ label }) => label).slice(0, quick ? 1 : undefined)
  const runs = (await attempt('runs: ours', 'ourRuns', { clocks })) ?? []
  const friction = []
  for (const { id: peer } of peers) {
    const found = await attempt(`runs: ${peer}`, 'peerRuns', { peer, clocks })
    if (found) {
      runs.push(...found.runs)
      friction.push(found.friction)
    }
  }
  const times = (await attempt('time of a step: engines', 'peerTimes', { care })) ?? []
  const framed = await attempt('time of a step: ours, frame by frame', 'frameTime', { care })
  const [first] = times
  if (first && framed)
    times.splice(1, 0, { ...framed, ratio: framed.step.median / first.step.median })

  const frontiers: Frontier[] = []
  for (const { id: problem, label, about, experiment, at } of problems) {
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
    contestants: contestants(),
    steps,
    peers: {
      scenes: [...peerScenes],
      clocks,
      runs,
      times,
      friction,
    },
    frontiers,
  }
  const checked = targets(measured)
  const profiles = []
  for (const given of quick ? [] : worthProfiling(measured.steps, checked)) {
    const what = `profile: ${given.scene}, ${given.integrator}, ${given.mixed ? 'mixed' : 'alone'}`
    const profile = await attempt(what, 'profile', given)
    if (profile) profiles.push(profile)
  }
  for (const { task, profiled } of quick ? [] : worthTakingApart(measured.steps, checked)) {
    const what = `parts: ${profiled.scene}, ${profiled.integrator}, ${task}`
    const profile = await attempt(what, task, { ...profiled, care })
    if (profile) profiles.push(profile)
  }
  return { ...measured, targets: checked, profiles, notRun }
}
