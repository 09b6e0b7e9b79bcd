/** Each engine's preset against the loop of that engine, written here on its own: frames in, steps out. */
import { describe, expect, it, test } from 'vitest'
import { createRun } from '../../../src/physics/index.ts'
import { engineChoices } from '../../../src/lab/engines/choices.ts'
import { engines } from '../../../src/lab/engines/index.ts'
import { readAddress, writeAddress } from '../../../src/lab/state/address.ts'
import { opening } from '../../../src/lab/state/opening.ts'

/** Times are whole units, of which all steps and caps below are multiples: no loop rounds. */
const UNIT = 1 / 48_000
const FRAMES = [800, 800, 333, 333, 1067, 1067, 1600, 1601, 2000, 3200, 4000, 4801, 9600, 10_000]
const LONG = [12_000, 12_345, 16_000, 17_000, 24_000, 30_000, 48_000, 800, 800]

type Loop = (frame: number) => number[]

/** Pays frame time into an accumulator; what is due beyond `most` steps is forgotten. */
function accumulator(step: number, cap = Infinity, most = Infinity): Loop {
  let owed = 0
  return (frame) => {
    owed += Math.min(frame, cap)
    const steps: number[] = []
    for (; owed >= step; owed -= step) if (steps.length < most) steps.push(step)
    return steps
  }
}

const once =
  (step: number): Loop =>
  () => [step]
const upTo =
  (cap: number): Loop =>
  (frame) => [Math.min(frame, cap)]

/** Each begins anew, with nothing owed. */
const loops: Readonly<Record<string, () => Loop>> = {
  'unity-fixed-update': () => accumulator(960, 16_000),
  'unity-update': () => upTo(16_000),
  godot: () => accumulator(800, Infinity, 8),
  unreal: () => upTo(1600),
  'unreal-substepping': () => (frame) => {
    const time = Math.min(frame, 6 * 800)
    const count = Math.ceil(time / 800)
    return Array.from({ length: count }, () => time / count)
  },
  bevy: () => accumulator(750, 12_000),
  phaser: () => accumulator(800, 9600),
  matter: () => accumulator(800, 3200, 2),
  planck: () => accumulator(800, 1600, 2),
  box2d: () => once(800),
  rapier: () => once(800),
  'game-maker': () => once(800),
  'pico-8': () => once(1600),
  'mono-game': () => accumulator(800, 24_000),
  libgdx: () => accumulator(800, 12_000),
  love: () => (frame) => [frame],
  pygame: () => once(800),
  source: () => accumulator(720),
  quake: () => upTo(4800),
  // Its parts are as long as they may be, and the last one is the rest: as many as equal ones.
  'quake-3': () => (frame) => {
    const count = Math.ceil(frame / 3168)
    return Array.from({ length: count }, () => frame / count)
  },
}

const SPEED = 20
const FRICTION = 0.25 * 9.81

describe.each(engines)('$label', ({ id, method }) => {
  it.each([
    ['frames of up to a fifth of a second', FRAMES],
    ['long frames', LONG],
  ])('takes the steps of its loop, and moves as its formula says: %s', (_, frames) => {
    const loop = loops[id]!()
    const run = createRun({
      scene: 'ramp',
      parameters: { angle: 0, muStatic: 0.25, muKinetic: 0.25, gravity: 9.81, speed: SPEED },
      ...method,
    })
    const start = run.motion.s
    let [x, v, time, taken] = [0, SPEED, 0, 0]
    for (const frame of frames) {
      run.frame(frame * UNIT)
      for (const step of loop(frame)) {
        const h = step * UNIT
        const before = v
        v = Math.max(0, v - FRICTION * h)
        x += (method.integrator === 'velocity-verlet' ? (before + v) / 2 : v) * h
        time += h
        taken++
      }
      expect(run.steps).toBe(taken)
      expect(run.stateTime).toBeCloseTo(time, 12)
      expect(run.motion.v).toBeCloseTo(v, 12)
      expect(run.motion.s - start).toBeCloseTo(x, 11)
    }
    expect(v).toBeGreaterThan(0)
  })

  it('stops where a step of its friction would turn the block round', () => {
    const run = createRun({
      scene: 'ramp',
      parameters: { angle: 0, muStatic: 0.5, muKinetic: 0.5, speed: 1 },
      ...method,
    })
    for (let i = 0; i < 60; i++) run.frame(1 / 60)
    expect(run.motion.v).toBe(0)
    expect(method.stopping).toBe('clamped')
  })
})

test('each engine has a loop here, and says what it does, what is left out and where that stands', () => {
  expect(engines.map(({ id }) => id)).toEqual(Object.keys(loops))
  for (const { label, does, leavesOut, source } of engines) {
    expect(does, label).toMatch(/^[A-Zl].{20,}\.$/)
    expect(leavesOut, label).toMatch(/^Left out: .{20,}\.$/)
    expect(source, label).toMatch(/\d/)
  }
})

describe('the menu of engines', () => {
  const frames = { kind: 'steady', fps: 45 } as const

  it('sets every runner to an engine, and leaves its frames and the scene', () => {
    for (const choice of engineChoices.slice(1)) {
      const { shown, label, watch } = choice.presetOf(opening, frames)
      expect(shown.problem, label).toBe('')
      expect(shown.state.parameters).toEqual(opening.parameters)
      expect(shown.state.runners.map((each) => each.frames)).toEqual(
        opening.runners.map((each) => each.frames),
      )
      const { does, leavesOut, source, method } = engines.find((each) => each.label === label)!
      for (const runner of shown.state.runners) expect(runner).toMatchObject(method)
      expect(watch).toBe(`${does} ${leavesOut} Source: ${source}.`)
      expect(readAddress(writeAddress(shown.state))).toEqual(shown.state)
    }
  })

  it('compares six, all on the frames of the runner that is looked at', () => {
    const { shown, watch } = engineChoices[0]!.presetOf(opening, frames)
    const { runners } = shown.state
    expect(runners).toHaveLength(6)
    const methods = runners.map(({ timestep, integrator, stopping }) =>
      JSON.stringify({ timestep, integrator, stopping }),
    )
    expect(new Set(methods).size).toBe(6)
    for (const runner of runners) expect(runner.frames).toEqual(frames)
    const named = engines.filter(({ label }) => watch.includes(label))
    expect(named.length).toBeGreaterThanOrEqual(6)
  })
})
