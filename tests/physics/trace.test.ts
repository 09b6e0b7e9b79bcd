import { describe, expect, it } from 'vitest'
import { integrators, scenes, simulate, stoppings, traceFrame } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const everything: Experiment[] = scenes.flatMap(({ id: scene }) =>
  integrators.flatMap(({ id: integrator }) =>
    stoppings.map(({ id: stopping }) => ({
      scene,
      integrator,
      stopping,
      parameters: { speed: -2 },
      timestep: { kind: 'substeps', step: 1 / 30 } as const,
      frames: { kind: 'steady', fps: 12 } as const,
      duration: 1,
    })),
  ),
)

describe('the trace of a frame', () => {
  it('is of the very steps that ran: begins and ends at the trajectory’s rows, bit for bit', () => {
    for (const experiment of everything) {
      const run = simulate(experiment)
      for (let row = 1; row <= run.frames; row++) {
        const steps = traceFrame(experiment, row)
        expect(steps[0]?.from ?? { s: run.s[row], v: run.v[row] }).toEqual({
          s: run.s[row - 1],
          v: run.v[row - 1],
        })
        expect(steps.at(-1)?.to ?? { s: run.s[row - 1], v: run.v[row - 1] }).toEqual({
          s: run.s[row],
          v: run.v[row],
        })
        for (const { stretches } of steps)
          for (const { tries } of stretches)
            for (const { evaluations } of tries)
              expect(evaluations.every(({ a }) => Number.isFinite(a))).toBe(true)
      }
    }
  })

  it('adds up: every evaluation of the run is in it, each stretch begins where the last ended, all tries of one alike', () => {
    for (const experiment of everything) {
      const run = simulate(experiment)
      const { muKinetic = 0, beltSpeed = 0 } = run.experiment.parameters
      let evaluations = 0
      for (let row = 1; row <= run.frames; row++)
        for (const { dt, from, to, stretches, standings } of traceFrame(experiment, row)) {
          expect(dt).toBeGreaterThan(0)
          evaluations += standings.length
          for (const { a, drive, v } of standings) expect([a, v]).toEqual([drive, beltSpeed])
          let begins = 0
          let at = from
          for (const { begins: start, tries, ends } of stretches) {
            // A sum of a few lengths of time, each rounded. On a belt a block may ride between two stretches.
            const rides = beltSpeed !== 0 && at.v === beltSpeed
            if (rides) at = tries[0]!.from
            else expect(Math.abs(start - begins)).toBeLessThanOrEqual(4 * Number.EPSILON)
            for (const tried of tries) {
              expect(tried.from).toEqual(at)
              expect(tried.dt).toBeLessThanOrEqual(dt - start)
              // Without friction, a block may turn without its slip direction.
              if (experiment.stopping === 'naive') expect(tried.slip).toBe(0)
              else if (at.v !== beltSpeed && muKinetic > 0)
                expect(tried.slip).toBe(Math.sign(at.v - beltSpeed))
              evaluations += tried.evaluations.length
              for (const { a, drive, press, v } of tried.evaluations)
                expect(a).toBe(drive - (tried.slip || Math.sign(v - beltSpeed)) * muKinetic * press)
            }
            begins = start + tries.at(-1)!.dt
            const end = stretches.find((each) => each.begins > start)?.tries[0]!.from ?? to
            if (ends === 'stop') expect(end.v).toBe(beltSpeed)
            else if (ends === undefined) expect(end).toEqual(tries.at(-1)!.to)
            at = end
          }
          if (at.v === beltSpeed && beltSpeed !== 0) expect(to.v).toBe(beltSpeed)
          else expect(at).toEqual(to)
        }
      expect(evaluations).toBe(run.evaluations)
    }
  })

  it('shows the stop that was located, the tries that found it, and the exact 0 it ends at', () => {
    const kicked: Experiment = {
      scene: 'ramp',
      parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
      frames: { kind: 'steady', fps: 10 },
      duration: 1,
    }
    // It stops after 0.69 s: in the seventh frame.
    const [step] = traceFrame(kicked, 7)
    expect(step!.outcome).toBe('at-rest')
    expect(step!.to.v).toBe(0)
    const [stretch] = step!.stretches
    expect(stretch!.ends).toBe('stop')
    expect(stretch!.tries[0]!.dt).toBe(0.1)
    expect(stretch!.tries[0]!.to.v).toBeGreaterThan(0)
    const kept = stretch!.tries.at(-1)!
    expect(kept.slip).toBe(-1)
    expect(Math.abs(kept.to.v)).toBeLessThan(1e-15)
    expect(kept.to.s).toBe(step!.to.s)
  })

  it('shows what static friction held against: at the stop, or where the block stood', () => {
    const kicked: Experiment = {
      scene: 'ramp',
      parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
      frames: { kind: 'steady', fps: 10 },
      duration: 1,
    }
    const [located] = traceFrame(kicked, 7)
    const [held] = located!.standings
    expect(located!.standings).toHaveLength(1)
    expect(held!.begins).toBe(located!.stretches[0]!.tries.at(-1)!.dt)
    expect(held).toMatchObject({ s: located!.to.s, v: 0 })
    expect(held!.drive).toBeCloseTo(9.81 * 0.258819, 5)
    expect(held!.press).toBeCloseTo(9.81 * 0.965926, 5)
    // The clamp stops it at the end of the frame; that it stays is found at the beginning of the next.
    const clamped: Experiment = { ...kicked, stopping: 'clamped' }
    expect(traceFrame(clamped, 7)[0]).toMatchObject({ standings: [], to: { v: 0 } })
    expect(traceFrame(clamped, 8)[0]).toMatchObject({ stretches: [], outcome: 'at-rest' })
    expect(traceFrame(clamped, 8)[0]!.standings).toMatchObject([
      { begins: 0, v: 0, drive: held!.drive, press: held!.press },
    ])
    expect(traceFrame(clamped, 9)).toEqual([])
    for (const frame of [1, 7])
      expect(traceFrame({ ...kicked, stopping: 'naive' }, frame)[0]!.standings).toEqual([])
  })

  it('shows each time that it sets off, and the acceleration that served again', () => {
    const back: Experiment = {
      scene: 'ramp',
      parameters: { angle: 40, speed: -2 },
      frames: { kind: 'steady', fps: 2 },
      duration: 1,
    }
    const [first, second] = [1, 2].flatMap((frame) => traceFrame(back, frame))
    expect(first!.outcome).toBe('moving')
    expect(first!.standings).toHaveLength(1)
    expect(first!.stretches.map(({ tries }) => tries.at(-1)!.slip)).toEqual([-1, 1])
    const { tries } = first!.stretches[1]!
    expect(tries[0]!.reused).toBeUndefined()
    expect(second!.stretches[0]!.tries[0]!.reused).toBe(tries.at(-1)!.evaluations.at(-1)!.a)
  })

  it('shows joints', () => {
    const run: Experiment = {
      scene: 'run-out',
      parameters: { length: 0.5 },
      frames: { kind: 'steady', fps: 2 },
      duration: 1,
    }
    const all = [1, 2].flatMap((frame) =>
      traceFrame(run, frame).flatMap(({ stretches }) => stretches.map(({ ends }) => ends)),
    )
    expect(all).toContain('joint')
    // A step that nothing cuts ends with none.
    expect(all).toContain(undefined)
  })

  it('shows where a block takes off, and where a step was halved that no air could brake so', () => {
    const ends = (experiment: Experiment) =>
      traceFrame(experiment, 1).flatMap(({ stretches }) => stretches.map((each) => each.ends))
    const frames = { kind: 'steady', fps: 2 } as const
    const parameters = { angle: 20, crestRadius: 3, position: 1.1, speed: 5.3 }
    expect(ends({ scene: 'crest', parameters, frames })).toEqual(['take-off'])
    const dive = { drag: 1, speed: 100 }
    expect(
      ends({ scene: 'fall', parameters: dive, integrator: 'explicit-euler', frames }),
    ).toContain('halved')
  })

  it('shows each try of a step to a tolerance, what was taken back, and why', () => {
    const pipe: Experiment = {
      ...{ scene: 'half-pipe', integrator: 'rk4', frames: { kind: 'steady', fps: 2 }, duration: 1 },
      timestep: { kind: 'tolerance', tolerance: 1e-8 },
    }
    const steps = traceFrame(pipe, 1)
    const attempts = new Set(steps.map(({ attempt }) => attempt!))
    expect(new Set([...attempts].map(({ accepted }) => accepted))).toEqual(new Set([true, false]))
    for (const attempt of attempts) {
      const { error, allowed, accepted } = attempt
      expect(error <= allowed).toBe(accepted)
      // The whole and its two halves; only of an attempt that was accepted the halves are kept.
      const [whole, ...halves] = steps.filter((step) => step.attempt === attempt)
      expect(halves.map(({ dt }) => dt)).toEqual([whole!.dt / 2, whole!.dt / 2])
      expect(whole!.takenBack).toBe(true)
      expect(halves.map(({ takenBack }) => takenBack)).toEqual([!accepted, !accepted])
    }
    const kept = steps.filter(({ takenBack }) => !takenBack)
    expect(kept.reduce((sum, { dt }) => sum + dt, 0)).toBeCloseTo(0.5, 12)
    for (const [i, { from }] of kept.slice(1).entries()) expect(from).toEqual(kept[i]!.to)
    expect(kept.at(-1)!.to.s).toBe(simulate(pipe).s[1])
  })

  it('refuses a frame that the run does not have', () => {
    expect(() => traceFrame({ scene: 'ramp', duration: 1 }, 61)).toThrow(
      /no frame 61; its frames are 1 to 60/,
    )
    expect(() => traceFrame({ scene: 'ramp' }, 0)).toThrow(RangeError)
  })
})
