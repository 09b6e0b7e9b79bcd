/** When steps are taken in a row, and for how many of them it is known that nothing happens. */
import { afterEach, describe, expect, it, vi } from 'vitest'
import { createRun, parseExperiment, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { FrameLoop } from '../../src/physics/frameLoop.ts'
import { velocityVerlet } from '../../src/physics/integrators/velocityVerlet.ts'
import { Motion } from '../../src/physics/motion.ts'
import { enterPiece } from '../../src/physics/piece.ts'
import { Random } from '../../src/physics/random.ts'
import { refuse, startRow } from '../../src/physics/row.ts'
import { freely } from '../../src/physics/scenes/law.ts'
import { located } from '../../src/physics/stopping/located.ts'
import { Recorder } from '../../src/physics/trajectory.ts'

afterEach(() => {
  vi.restoreAllMocks()
})

/** Down or up a ramp without an end, for longer than is asked for. */
const sliding = (speed: number): Experiment => ({
  scene: 'ramp',
  parameters: { angle: 30, muStatic: 0.2, muKinetic: 0.2, speed },
  integrator: 'velocity-verlet',
  stopping: 'located',
  frames: { kind: 'steady', fps: 1000 },
  duration: 5,
})

/** How often the method and the stopping rule have been called. */
function calls() {
  const step = vi.spyOn(velocityVerlet, 'step')
  const advance = vi.spyOn(located, 'advance')
  return () => ({ step: step.mock.calls.length, advance: advance.mock.calls.length })
}

describe.each([1, -1000])('a block at %d m/s', (speed) => {
  // A row is of 1024 steps at the most, and the clock is read 1024 frames at a time, the last of which stands by itself.
  const rows = Math.ceil(5000 / 1024)

  it('has the method called once for all steps of a frame in which nothing happens', () => {
    const count = calls()
    const run = createRun({
      ...sliding(speed),
      timestep: { kind: 'substeps', step: 1e-3 },
    })
    run.frame(5)
    expect(run.steps).toBe(5000)
    expect(count()).toEqual({ step: rows, advance: 0 })
  })

  it('has it called once for many frames of one step', () => {
    const count = calls()
    expect(simulate(sliding(speed)).frames).toBe(5000)
    expect(count()).toEqual({ step: 2 * rows, advance: 0 })
  })

  it('asks nothing of the stopping rule frame by frame either', () => {
    const run = createRun(sliding(speed))
    const count = calls()
    for (let i = 0; i < 100; i++) run.frame(1e-3)
    // The run had its method before the calls were counted.
    expect(count().advance).toBe(0)
  })

  it('is counted in frames as in steps', () => {
    const experiment = parseExperiment(sliding(speed))
    const loop = new FrameLoop(experiment)
    const recorder = new Recorder(5001)
    recorder.record(loop.run)
    loop.row(recorder)
    expect(loop.run.frames).toBe(recorder.last)
    expect(loop.run.steps).toBe(recorder.last)
    expect(recorder.last).toBe(1023)
  })
})

describe('the steps in which nothing can happen', () => {
  /** At s with v on a piece of constant acceleration between two joints, before a row of steps. */
  function before(s: number, v: number, a: number, dt: number, asked: number, joints: number[]) {
    const pieces = Array.from({ length: joints.length + 1 }, () => ({ drive: a, press: 0 }))
    const motion = new Motion({ ...freely(1), joints, forces: pieces }, s, v)
    motion.slipHeld = true
    enterPiece(motion)
    motion.dt = dt
    motion.asked = asked
    startRow(motion)
    return motion
  }

  it('are fewer than lead to the turn or to a joint, and not by far', () => {
    const random = new Random(5)
    const next = () => random.next() / 2 ** 32
    let some = 0
    for (let i = 0; i < 2000; i++) {
      const side = () => (next() < 0.5 ? -1 : 1)
      const v = side() * (0.1 + 10 * next())
      const a = side() * 20 * next()
      const dt = 1e-4 + 1e-2 * next()
      const [from, to] = [-0.1 - 5 * next(), 0.1 + 5 * next()]
      // The speed at most doubles meanwhile, which the bound allows for: so that it is not too careful by more than that.
      const asked = Math.min(2000, Math.max(2, Math.floor(Math.abs(v / (a * dt)))))
      const { free, inRow } = before(0, v, a, dt, asked, [from, to])
      let n = 0
      for (;;) {
        const t = (n + 1) * dt
        const s = v * t + 0.5 * a * t * t
        if (n === asked || (v + a * t) * v <= 0 || s <= from || s >= to) break
        n++
      }
      expect(inRow).toBe(1)
      expect(free).toBeLessThanOrEqual(n)
      // Half as many as would at twice the speed that it has at first, where it may go on with half of that on average.
      expect(free).toBeGreaterThanOrEqual(Math.min(asked, Math.floor(n / 8) - 1))
      if (free > 10) some++
    }
    expect(some).toBeGreaterThan(1000)
  })

  it('are none where rounding alone could reach the end of the piece', () => {
    // An ulp of 1e12 m is 1.2e-4 m: a thousand steps are not told apart from 0.1 m.
    for (const side of [1, -1])
      expect(
        before(1e12, side, 0, 1e-3, 1000, [1e12 - 50, 1e12 + 50]).free,
        `to side ${side}`,
      ).toBeLessThanOrEqual(0)
  })

  it('are all of those asked for where nothing pulls, and no end is near', () => {
    expect(before(0, 1, 0, 1e-3, 700, []).free).toBe(700)
    expect(before(0, -1, 0, 1e-3, 700, [-1e9, 1e9]).free).toBe(700)
  })
})

describe('a step of a row that is not kept', () => {
  it('leaves no count behind, of evaluations or of what could not be solved', () => {
    const motion = new Motion({ ...freely(1), forces: [{ drive: 0, press: 0 }] }, 0, 1)
    motion.inRow = 1
    motion.keptEvaluations = 1
    motion.unsolved = 3
    motion.evaluations = 8
    motion.leaveUnsolved()
    refuse(motion)
    expect(motion).toMatchObject({ inRow: 0, evaluations: 1, unsolved: 3 })
    // The next had its equation solved.
    refuse(motion)
    expect(motion).toMatchObject({ evaluations: 1, unsolved: 3 })
  })

  it('is taken by the stopping rule with no evaluation more', () => {
    const braking: Experiment = {
      ...sliding(1),
      parameters: { angle: 0, muStatic: 0.5, muKinetic: 0.5, speed: 1 },
      stopping: 'clamped',
      frames: { kind: 'steady', fps: 1 },
      duration: 1,
    }
    // The acceleration at the step's beginning, and at its end.
    expect(simulate(braking).evaluations).toBe(2)
    expect(simulate(braking).outcome.kind).toBe('moving')
  })
})

describe('evaluations', () => {
  it('are none in a frame of no length', () => {
    const run = createRun(sliding(1))
    run.frame(0)
    expect(run.evaluations).toBe(0)
    run.frame(1e-3)
    const { evaluations } = run
    run.frame(0)
    expect(run.evaluations).toBe(evaluations)
    expect(run.motion.v).toBeGreaterThan(1)
  })

  it('serve two steps of velocity Verlet where no friction could turn round, whatever the stopping rule', () => {
    const smooth = { angle: 30, muStatic: 0, muKinetic: 0, speed: 1 }
    for (const stopping of ['naive', 'clamped', 'located'] as const) {
      const { evaluations } = simulate({ ...sliding(1), parameters: smooth, stopping, duration: 1 })
      expect(evaluations, stopping).toBe(1001)
    }
  })
})
