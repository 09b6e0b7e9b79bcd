import { describe, expect, test } from 'vitest'
import { simulate } from '../../../src/physics/index.ts'
import type { Experiment, Timestep } from '../../../src/physics/index.ts'
import { clockworkOf, stepTimes, triedTimes } from '../../../src/lab/state/clockwork.ts'
import { noteOf, stripText } from '../../../src/panels/strip/stripWords.ts'
import type { SimulatedRunner } from '../../../src/lab/state/simulation.ts'

type FramesChoice = NonNullable<Experiment['frames']>

function run(timestep: Timestep, frames: FramesChoice, others: Partial<Experiment> = {}) {
  return simulate({ scene: 'half-pipe', timestep, frames, duration: 3, ...others })
}

const hitches: FramesChoice = { kind: 'hitch', fps: 60, every: 0.7, length: 0.3 }

const lossy: [Timestep, FramesChoice][] = [
  [
    { kind: 'fixed', step: 1 / 60, maxSteps: 4 },
    { kind: 'steady', fps: 10 },
  ],
  [{ kind: 'fixed', step: 1 / 50, maxSteps: 3 }, hitches],
  [{ kind: 'fixed', step: 1 / 50, cap: 0.11 }, hitches],
  [{ kind: 'fixed', step: 1 / 50, cap: 0.11, maxSteps: 3 }, hitches],
  [{ kind: 'substeps', step: 1 / 60, maxSteps: 6 }, hitches],
  [{ kind: 'capped', cap: 0.05 }, hitches],
]

const lossless: [Timestep, FramesChoice][] = [
  [
    { kind: 'fixed', step: 1 / 60 },
    { kind: 'steady', fps: 144 },
  ],
  [
    { kind: 'fixed', step: 1 / 60 },
    { kind: 'jitter', fps: 50, amount: 0.5, seed: 3 },
  ],
  [{ kind: 'fixed', step: 0.001 }, hitches],
]

describe.each([...lossy, ...lossless])('%o at %o', (timestep, frames) => {
  const trajectory = run(timestep, frames)
  const { time, step, accumulator, lost } = clockworkOf(trajectory)

  test('ticks are at the times of the frames', () => expect(time).toBe(trajectory.time))

  test('what is not simulated and not lost is in the accumulator, less than a step', () => {
    for (let row = 0; row <= trajectory.frames; row++) {
      const late = trajectory.time[row]! - trajectory.stateTime[row]!
      expect(accumulator[row]! + lost[row]!).toBeCloseTo(late, 9)
      expect(accumulator[row]).toBeGreaterThanOrEqual(0)
      expect(accumulator[row]).toBeLessThan((step ?? 0) + 1e-9)
    }
  })

  test('lost time only grows, up to what the policy says it lost', () => {
    for (let row = 1; row <= trajectory.frames; row++)
      expect(lost[row]).toBeGreaterThanOrEqual(lost[row - 1]!)
    expect(lost.at(-1)).toBeCloseTo(trajectory.lostTime, 9)
  })

  test('every step has its tick, in a frame that had the time for it', () => {
    const steps = [...stepTimes(trajectory, 0, trajectory.frames)]
    if (step === undefined) return expect(steps).toEqual([])
    expect(steps).toHaveLength(trajectory.steps)
    steps.forEach((at, i) => {
      if (i > 0) expect(at - steps[i - 1]!).toBeGreaterThan(step - 1e-9)
    })
    for (let row = 1; row <= trajectory.frames; row++)
      for (const at of stepTimes(trajectory, row, row)) {
        expect(at).toBeGreaterThan(time[row - 1]! - 1e-9)
        expect(at).toBeLessThan(time[row]! + 1e-9)
      }
    if (trajectory.lostTime === 0)
      steps.forEach((at, i) => expect(at).toBeCloseTo((i + 1) * step, 9))
  })
})

test.each(lossy)('%o loses time at %o', (timestep, frames) => {
  expect(run(timestep, frames).lostTime).toBeGreaterThan(0.3)
})

test.each(lossless)('%o loses none at %o', (timestep, frames) => {
  expect(clockworkOf(run(timestep, frames)).lost.every((lost) => lost === 0)).toBe(true)
})

test('where the block has left the track nothing is left to be stepped', () => {
  const trajectory = run(
    { kind: 'fixed', step: 1 / 60 },
    { kind: 'steady', fps: 60 },
    {
      parameters: { position: 3.1 },
      integrator: 'explicit-euler',
      duration: 10,
    },
  )
  expect(trajectory.outcome.kind).toBe('left-the-track')
  const { accumulator, lost } = clockworkOf(trajectory)
  expect(accumulator.at(-1)).toBe(0)
  expect(lost.at(-1)).toBe(0)
})

describe('in words', () => {
  const runner = (timestep: Timestep, frames: FramesChoice) =>
    ({ name: 'A', trajectory: run(timestep, frames) }) as SimulatedRunner

  test('time that was lost', () => {
    const capped = runner(...lossy[0]!)
    expect(noteOf(capped, 0)).toBe('A: 1.00\u202fs lost')
    expect(stripText(capped, 3)).toMatch(
      /^A: 30 frames, 120 physics steps of 16\.7\u202fms, .* lost/,
    )
  })

  test('time that goes astray without delta time', () => {
    const slow = runner({ kind: 'per-frame', step: 1 / 60 }, { kind: 'steady', fps: 10 })
    expect(noteOf(slow, 0)).toBe('A: physics is on time')
    expect(noteOf(slow, 1)).toBe('A: physics is 0.83\u202fs behind')
    const fast = runner({ kind: 'per-frame', step: 1 / 60 }, { kind: 'steady', fps: 120 })
    expect(noteOf(fast, 1)).toBe('A: physics is 1.00\u202fs ahead')
  })

  test('nothing where there is nothing to say', () => {
    const variable = runner({ kind: 'variable' }, { kind: 'steady', fps: 30 })
    expect(noteOf(variable, 1)).toBe('')
    expect(stripText(variable, 1)).toBe('A: 90 frames.')
  })

  test('what the accumulator holds now', () => {
    const fixed = runner({ kind: 'fixed', step: 0.1 }, { kind: 'steady', fps: 40 })
    expect(stripText(fixed, 0.15)).toContain('50\u202fms in the accumulator')
    expect(stripText(fixed, 0.2)).toContain('0.00\u202fs in the accumulator')
  })
})

describe('under a tolerance', () => {
  const trajectory = run({ kind: 'tolerance', tolerance: 1e-6 }, { kind: 'steady', fps: 10 })
  const { tries } = clockworkOf(trajectory)

  test('the steps that were kept fill the run from its start to its end, one after the other', () => {
    const kept = [...triedTimes(trajectory, tries!, true)]
    expect(kept).toHaveLength(trajectory.steps)
    expect([...kept].sort((a, b) => a - b)).toEqual(kept)
    expect(kept.at(-1)).toBeCloseTo(3, 12)
    for (const frame of trajectory.time.slice(1))
      expect(kept.some((time) => Math.abs(time - frame) < 1e-12)).toBe(true)
  })

  test('its words tell how long they are and what was taken back', () => {
    const refused = [...triedTimes(trajectory, tries!, false)].length
    const text = stripText({ name: '10 fps', trajectory } as SimulatedRunner, 0)
    expect(text).toMatch(
      new RegExp(`${trajectory.steps} physics steps of .* to .*, ${refused} tr(y|ies) taken back`),
    )
  })

  test('a run of too many steps is not repeated for them', () => {
    const dense = { kind: 'tolerance', tolerance: 1e-4 } as const
    const euler = run(
      dense,
      { kind: 'steady', fps: 30 },
      { integrator: 'explicit-euler', duration: 1 },
    )
    expect(euler.steps).toBeGreaterThan(20_000)
    expect(clockworkOf(euler).tries).toBeUndefined()
  })
})
