/** Steps in which nothing happens are taken in a row: that spares work, and must show in nothing else. */
import { describe, expect, it } from 'vitest'
import { fingerprintExperiments } from '../../src/measure/index.ts'
import { createRun, parseExperiment, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { FrameLoop } from '../../src/physics/frameLoop.ts'

/** A run whose every frame is run by itself. */
function oneByOne(experiment: Experiment) {
  const loop = new FrameLoop(parseExperiment(experiment))
  const { run } = loop
  const rows = [{ s: run.motion.s, v: run.motion.v, heat: run.heat, time: 0, stateTime: 0 }]
  while (loop.goesOn) {
    loop.next()
    const { motion, heat, time, stateTime } = run
    rows.push({ s: motion.s, v: motion.v, heat, time, stateTime })
  }
  return { rows, run }
}

/** Blocks that stop, turn, or reach a joint after many short frames of constant acceleration, at instants of every kind. */
const long: Experiment[] = Array.from({ length: 40 }, (_, i) => {
  const chance = (i * 0.6180339887) % 1
  const rubbing = i % 4 === 3 ? 0 : 0.3 + chance / 2
  return {
    scene: i % 2 === 0 ? 'ramp' : 'run-out',
    parameters: {
      angle: i % 4 === 0 ? 0 : 20,
      muStatic: rubbing,
      muKinetic: rubbing,
      speed: (i % 3 === 0 ? -4 : 4) * chance,
      ...(i % 2 === 1 && { length: 0.2 + chance, position: i % 5 === 0 ? 1e6 : 0 }),
    },
    integrator: 'velocity-verlet',
    stopping: i % 5 === 4 ? 'clamped' : 'located',
    frames:
      i % 3 === 1
        ? { kind: 'jitter', fps: 700, amount: 0.9, seed: i }
        : { kind: 'steady', fps: 200 + 800 * chance },
    duration: 3,
  }
})

describe('a row of frames', () => {
  it('ends in the same bits as frames one by one, and has counted as much', () => {
    for (const experiment of [...fingerprintExperiments(), ...long]) {
      const where = JSON.stringify(experiment)
      const inRows = simulate(experiment)
      const { rows, run } = oneByOne(experiment)
      expect(rows.length, where).toBe(inRows.frames + 1)
      for (const name of ['s', 'v', 'time', 'stateTime'] as const) {
        const different = rows.findIndex((row, i) => !Object.is(row[name], inRows[name][i]))
        expect(different, `${name} of ${where}`).toBe(-1)
      }
      // The same sums of heat in another order: by an ulp of the whole a row.
      const most = rows.at(-1)!.heat
      const apart = rows.map(({ heat }, i) => Math.abs(heat - inRows.heat[i]!))
      expect(Math.max(...apart), `heat of ${where}`).toBeLessThanOrEqual(
        rows.length * Number.EPSILON * most,
      )
      const { steps, evaluations, lostTime, outcome } = run
      expect({ steps, evaluations, lostTime, outcome, unsolved: run.motion.unsolved }).toEqual({
        steps: inRows.steps,
        evaluations: inRows.evaluations,
        lostTime: inRows.lostTime,
        outcome: inRows.outcome,
        unsolved: inRows.unsolved,
      })
    }
  })

  it('of a hundred equal steps in a frame is a hundred frames of one', () => {
    const experiment: Experiment = {
      scene: 'half-pipe',
      parameters: { muKinetic: 0.1, muStatic: 0.1 },
      integrator: 'rk4',
      timestep: { kind: 'substeps', step: 1 / 64 / 100 },
    }
    const whole = createRun(experiment)
    const parts = createRun(experiment)
    for (let frame = 0; frame < 200; frame++) {
      whole.frame(1 / 64)
      for (let i = 0; i < 100; i++) parts.frame(1 / 64 / 100)
      expect([whole.motion.s, whole.motion.v]).toEqual([parts.motion.s, parts.motion.v])
      expect(whole.steps).toBe(parts.steps)
      expect(whole.evaluations).toBe(parts.evaluations)
    }
    expect(whole.outcome.kind).toBe(parts.outcome.kind)
  })
})
