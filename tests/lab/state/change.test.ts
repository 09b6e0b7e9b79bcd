import { describe, expect, test } from 'vitest'
import { frameClocks, scenes, simulate, timesteps } from '../../../src/physics/index.ts'
import { experimentOf } from '../../../src/lab/state/check.ts'
import { modeOf, modes } from '../../../src/lab/state/modes.ts'
import { opening, openingOf } from '../../../src/lab/state/opening.ts'
import { changed } from '../../../src/lab/state/change.ts'
import { choose } from '../../../src/lab/state/choose.ts'

const ends = (state: typeof opening) =>
  state.runners.map((runner) => {
    const { drawnS, outcome } = simulate(experimentOf(state, runner))
    return { s: drawnS.at(-1)!, kind: outcome.kind }
  })

describe('the opening', () => {
  test('tells its story: three frame rates stop at three places, short of the exact one', () => {
    expect(modeOf(opening)?.id).toBe('clamped')
    expect(ends(opening).map(({ s }) => s.toFixed(2))).toEqual(['-1.47', '-1.64', '-1.70'])
    expect(ends(opening).every(({ kind }) => kind === 'at-rest')).toBe(true)
  })

  test.each([
    ['no-delta-time', ['-0.72', '-1.56', '-1.68']],
    ['paper', ['-1.38', '-1.61', '-1.69']],
    ['fixed-step', ['-1.68', '-1.68', '-1.68']],
    ['located', ['-1.72', '-1.72', '-1.72']],
  ] as const)('%s sets all runners and is then the mode', (mode, places) => {
    const state = changed(opening, { kind: 'mode', mode })
    expect(modeOf(state)?.id).toBe(mode)
    expect(ends(state).map(({ s }) => s.toFixed(2))).toEqual(places)
  })

  test.each(scenes.map(({ id }) => id))('of %s runs, and shows a difference', (id) => {
    const state = changed(opening, { kind: 'scene', scene: id })
    expect(state.parameters).toEqual(openingOf(id).parameters)
    const places = ends(state).map(({ s }) => s)
    expect(Math.max(...places) - Math.min(...places)).toBeGreaterThan(0.1)
  })
})

test('a scene keeps the runners', () => {
  const state = changed(changed(opening, { kind: 'mode', mode: 'located' }), {
    kind: 'scene',
    scene: 'spring',
  })
  expect(state.scene).toBe('spring')
  expect(modeOf(state)?.id).toBe('located')
})

test('one runner that goes its own way ends the mode', () => {
  for (const { id } of modes) {
    const state = changed(opening, { kind: 'mode', mode: id })
    const other = changed(state, { kind: 'runner', index: 1, values: { integrator: 'midpoint' } })
    expect(modeOf(other)).toBeUndefined()
  }
})

describe('friction', () => {
  const set = (values: Record<string, number>) =>
    changed(opening, { kind: 'parameters', values }).parameters

  test('static follows kinetic up', () => {
    expect(set({ muKinetic: 0.8 })).toMatchObject({ muKinetic: 0.8, muStatic: 0.8 })
  })
  test('kinetic follows static down', () => {
    expect(set({ muStatic: 0.2 })).toMatchObject({ muKinetic: 0.2, muStatic: 0.2 })
  })
  test('neither follows where it need not', () => {
    expect(set({ muKinetic: 0.3 })).toMatchObject({ muKinetic: 0.3, muStatic: 0.5 })
    expect(set({ muStatic: 0.9 })).toMatchObject({ muKinetic: 0.5, muStatic: 0.9 })
  })
})

describe('what can’t be run is refused, and says why', () => {
  test.each([
    [{ kind: 'parameters', values: { angle: 91 } }, 'parameters.angle: 91 is not in 0…90'],
    [{ kind: 'parameters', values: { angle: 'x' } }, 'parameters.angle: "x" is not a number'],
    [{ kind: 'parameters', values: { angel: 3 } }, 'did you mean angle?'],
    [{ kind: 'duration', duration: -1 }, 'duration: -1 is not in'],
    [
      { kind: 'option', index: 1, of: 'frames', key: 'fps', value: 0 },
      'runners[1].frames.fps: 0 is not in 1…10000',
    ],
    [{ kind: 'remove', index: 0 }, undefined],
  ] as const)('%j', (change, message) => {
    if (message) expect(() => changed(opening, change)).toThrow(message)
    else expect(changed(opening, change).runners).toHaveLength(2)
  })

  test('a problem of what all runners share is told once', () => {
    try {
      changed(opening, { kind: 'parameters', values: { angle: 91 } })
      expect.unreachable()
    } catch (error) {
      expect((error as Error).message.split('\n')).toHaveLength(1)
    }
  })

  test('the last runner stays', () => {
    const one = [1, 0].reduce((state, index) => changed(state, { kind: 'remove', index }), opening)
    expect(one.runners).toHaveLength(1)
    expect(() => changed(one, { kind: 'remove', index: 0 })).toThrow('runners')
  })
})

describe('runners', () => {
  test('come up to eight, each in a look of its own, and keep theirs when others go', () => {
    let state = opening
    while (state.runners.length < 8) state = changed(state, { kind: 'add' })
    expect(new Set(state.runners.map(({ paletteIndex }) => paletteIndex)).size).toBe(8)
    expect(() => changed(state, { kind: 'add' })).toThrow('9 are not in 1…8')
    const gone = changed(state, { kind: 'remove', index: 2 })
    expect(gone.runners.map(({ paletteIndex }) => paletteIndex)).toEqual([0, 1, 3, 4, 5, 6, 7])
    const back = changed(gone, { kind: 'duplicate', index: 0 })
    expect(back.runners[1]).toEqual({ ...back.runners[0], paletteIndex: 2 })
  })

  test('an option that two clocks share keeps its value, the others begin at theirs', () => {
    const before = { kind: 'jitter', fps: 24, amount: 0.9, seed: 7 } as const
    for (const { id, options } of frameClocks) {
      const chosen = choose('frames', id, before)
      expect(Object.keys(chosen)).toEqual(['kind', ...Object.keys(options)])
      if ('fps' in chosen) expect(chosen.fps).toBe(24)
      if ('seed' in chosen) expect(chosen.seed).toBe(7)
    }
    for (const { id } of timesteps) {
      const chosen = choose('timestep', id, { kind: 'substeps', step: 0.02, maxSteps: 3 })
      if ('step' in chosen) expect(chosen.step).toBe(0.02)
      if ('maxSteps' in chosen) expect(chosen.maxSteps).toBe(3)
    }
  })

  test('a bound that was none is not carried over to a policy that needs one', () => {
    const uncapped = choose('timestep', 'fixed', { kind: 'variable' })
    expect(uncapped).toMatchObject({ cap: 60 })
    expect(choose('timestep', 'capped', uncapped)).toEqual({ kind: 'capped', cap: 0.05 })
  })
})
