/** Each engine's preset against the loop of that engine, written here on its own: frames in, steps out. */
import { describe, expect, it, test } from 'vitest'
import { lostBy, yourEngine } from '../../src/figures/yourEngine.ts'
import { readValues } from '../../src/figures/shared/control.ts'
import { spreadOf, trajectoryErrors } from '../../src/measure/index.ts'
import { createRun, simulate } from '../../src/physics/index.ts'
import { engineChoices } from '../../src/lab/presets/engines.ts'
import { engines } from '../../src/engines/index.ts'
import { readAddress, writeAddress } from '../../src/lab/state/address.ts'
import { changed } from '../../src/lab/state/change.ts'
import type { Change } from '../../src/lab/state/change.ts'
import { namesOf } from '../../src/lab/state/names.ts'
import { opening } from '../../src/lab/state/opening.ts'

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

/** Cuts a frame into equal parts, and forgets what is more than `most` of the longest. */
const parts =
  (longest: number, most: number): Loop =>
  (frame) => {
    const time = Math.min(frame, most * longest)
    const count = Math.ceil(time / longest)
    return Array.from({ length: count }, () => time / count)
  }

/** Each begins anew, with nothing owed. */
const loops: Readonly<Record<string, () => Loop>> = {
  'unity-fixed-update': () => accumulator(960, 16_000),
  'unity-update': () => upTo(16_000),
  godot: () => accumulator(800, Infinity, 8),
  unreal: () => upTo(1600),
  'unreal-substepping': () => parts(800, 6),
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
  'quake-3': () => parts(3168, Infinity),
}

/** The loops after the change that each engine's advice asks for. */
const saferLoops: Readonly<Record<string, () => Loop>> = {
  ...Object.fromEntries(
    ['matter', 'planck', 'box2d', 'rapier', 'game-maker', 'love', 'pygame', 'quake'].map((id) => [
      id,
      () => accumulator(800, Infinity, 60),
    ]),
  ),
  'unity-fixed-update': () => accumulator(480, 48_000),
  'unity-update': () => accumulator(960, 16_000),
  godot: () => accumulator(400, Infinity, 120),
  unreal: () => parts(800, 16),
  'unreal-substepping': () => parts(400, 16),
  bevy: () => accumulator(375, 48_000),
  phaser: () => accumulator(400, 48_000),
  'pico-8': () => accumulator(1600, Infinity, 30),
  'mono-game': () => accumulator(400, 48_000),
  libgdx: () => accumulator(400, 48_000),
  source: () => accumulator(720),
  'quake-3': () => accumulator(384),
}

const SPEED = 20
const FRICTION = 0.25 * 9.81

const settings = engines.flatMap(({ id, label, method, safer }) => [
  { label, method, loop: loops[id]! },
  {
    label: `${label}, on the safe side`,
    method: { ...method, timestep: safer.timestep },
    loop: saferLoops[id]!,
  },
])

describe.each(settings)('$label', ({ method, loop: begin }) => {
  it.each([
    ['frames of up to a fifth of a second', FRAMES],
    ['long frames', LONG],
  ])('takes the steps of its loop, and moves as its formula says: %s', (_, frames) => {
    const loop = begin()
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

describe.each(engines)('the change on $label', ({ id, method, safer }) => {
  const clocks = ['steady', 'jitter', 'missed-vsync', 'hitch'] as const
  const played = [5, 20, 50].flatMap((fps) =>
    clocks.map((clock) => {
      const outcome = (settings: string) => {
        const values = readValues(yourEngine.controls, { engine: id, settings, clock, fps })
        const runs = yourEngine.experiments(values).map(simulate)
        const off = runs.map((run) => Math.abs(trajectoryErrors(run).atEnd))
        const lost = runs.map((run) => Math.abs(lostBy(run)))
        return [spreadOf(runs).distance, Math.max(...off), Math.max(...lost)]
      }
      return { before: outcome('default'), after: outcome('safer') }
    }),
  )

  it('brings players no further apart, off or behind, and on some frames helps', () => {
    for (const { before, after } of played)
      before.forEach((each, i) => expect(after[i]).toBeLessThan(each + 1e-12))
    const helps = played.some(({ before, after }) =>
      before.some((each, i) => after[i]! < 0.9 * each - 1e-9),
    )
    expect(helps).toBe(id !== 'source')
    if (id === 'source') expect(safer.timestep).toEqual(method.timestep)
  })

  it('leaves no spread where its steps are fixed, and loses no time where it says so', () => {
    const isFixed = safer.timestep.kind === 'fixed'
    const upTo = /Frames of up to (\S+) (?:s|second) ?(?:s )?then lose nothing/.exec(safer.how)?.[1]
    for (const { after } of played) {
      if (isFixed && id !== 'unity-update') expect(after[0]).toBe(0)
      if (upTo === 'a') expect(after[2]).toBe(0)
    }
    const longest = { a: 1, '0.27': 16 / 60, '0.13': 16 / 120 }[upTo ?? '']
    if (!longest) return
    const run = createRun({ scene: 'ramp', ...method, timestep: safer.timestep })
    run.frame(0.999 * longest)
    expect(run.lostTime).toBe(0)
    run.frame(1.02 * longest)
    expect(run.lostTime).toBeGreaterThan(0)
  })
})

const frames = { kind: 'steady', fps: 45 } as const

describe('the menu of engines', () => {
  it('sets every runner to an engine, and leaves its frames and the scene', () => {
    for (const choice of engineChoices.slice(1)) {
      const { shown, label, watch } = choice.presetOf(opening, 0)
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

  it('compares six, all on the frames of the runner that is looked at, each called by its engine', () => {
    const { shown } = engineChoices[0]!.presetOf(opening, 1)
    const { runners } = shown.state
    expect(runners).toHaveLength(6)
    const methods = runners.map(({ timestep, integrator, stopping }) =>
      JSON.stringify({ timestep, integrator, stopping }),
    )
    expect(new Set(methods).size).toBe(6)
    for (const runner of runners) expect(runner.frames).toEqual(opening.runners[1]!.frames)
    const names = namesOf(runners)
    expect(new Set(names).size).toBe(6)
    for (const name of names) expect(engines.map(({ label }) => label as string)).toContain(name)
  })
})

describe('a runner that an engine moves', () => {
  const one = { ...engines[0].method, engine: engines[0].label }
  const godot = changed(opening, { kind: 'runner', index: 1, values: one })
  const named = (change: Change) => changed(godot, change).runners[1]!.engine

  it('is written as the engine’s id, and read again', () => {
    expect(writeAddress(godot)).toContain(
      `runners=10/semi-implicit-euler/clamped;30/${engines[0].id};`,
    )
    expect(readAddress(writeAddress(godot))).toEqual(godot)
    const [runner] = readAddress('runners=60/godot/rk4').runners
    expect(runner).toMatchObject({ integrator: 'rk4', timestep: { kind: 'fixed', maxSteps: 8 } })
    expect(runner!.engine).toBeUndefined()
    expect(() => readAddress('runners=60/unity')).toThrow(/nor an engine such as godot/)
  })

  it('keeps the name while only its frames change, and loses it with its method', () => {
    const index = 1
    expect(named({ kind: 'option', index, of: 'frames', key: 'fps', value: 45 })).toBe(one.engine)
    expect(named({ kind: 'runner', index, values: { frames } })).toBe(one.engine)
    expect(named({ kind: 'runner', index, values: { hidden: true } })).toBe(one.engine)
    expect(named({ kind: 'runner', index, values: { integrator: 'rk4' } })).toBeUndefined()
    expect(
      named({ kind: 'option', index, of: 'timestep', key: 'step', value: 0.01 }),
    ).toBeUndefined()
    expect(named({ kind: 'mode', mode: 'located' })).toBeUndefined()
    const twice = changed(godot, { kind: 'duplicate', index }).runners
    expect(twice.map(({ engine }) => engine)).toEqual([
      undefined,
      one.engine,
      one.engine,
      undefined,
    ])
  })

  it('is called by the engine where frames don’t tell runners apart', () => {
    const alike = changed(godot, {
      kind: 'runner',
      index: 0,
      values: { frames: godot.runners[1]!.frames },
    })
    expect(namesOf(alike.runners.slice(0, 2))).toEqual(['30 fps', engines[0].label])
    expect(namesOf(godot.runners)).toEqual(['10 fps', '30 fps', '120 fps'])
  })
})
