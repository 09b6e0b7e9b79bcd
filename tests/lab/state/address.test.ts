import { describe, expect, test } from 'vitest'
import {
  frameClocks,
  integrators,
  scenes,
  stoppings,
  timesteps,
} from '../../../src/physics/index.ts'
import { isAddress, readAddress, writeAddress } from '../../../src/lab/state/address.ts'
import { opening, openingOf } from '../../../src/lab/state/opening.ts'
import { changed } from '../../../src/lab/state/change.ts'
import { choose } from '../../../src/lab/state/choose.ts'
import type { LabState, RunnerState } from '../../../src/lab/state/state.ts'
import { samples } from '../../samples.ts'

test('the opening needs no words, a scene’s opening only its name', () => {
  expect(writeAddress(opening)).toBe('')
  expect(readAddress('')).toEqual(opening)
  for (const { id } of scenes) {
    const state = changed(opening, { kind: 'scene', scene: id })
    expect(writeAddress(state)).toBe(id === 'ramp' ? '' : `scene=${id}`)
    expect(readAddress(`scene=${id}`)).toEqual({ ...openingOf(id) })
  }
})

test('it can be read', () => {
  let state = changed(opening, { kind: 'parameters', values: { angle: 20 } })
  state = changed(state, { kind: 'mode', mode: 'located' })
  expect(writeAddress(state)).toBe('angle=20&runners=10;30;120')
  state = changed(state, { kind: 'mode', mode: 'fixed-step' })
  state = changed(state, { kind: 'runner', index: 2, values: { hidden: true } })
  expect(writeAddress(state)).toBe(
    'angle=20&runners=10/fixed(step:1/60)/semi-implicit-euler/clamped;' +
      '30/fixed(step:1/60)/semi-implicit-euler/clamped;' +
      '120/fixed(step:1/60)/semi-implicit-euler/clamped/hidden',
  )
})

test.each([
  // The opening has μs = μk = 0.5: the one that is not named follows.
  ['muKinetic=0.8', { muStatic: 0.8, muKinetic: 0.8 }],
  ['muStatic=0.2', { muStatic: 0.2, muKinetic: 0.2 }],
  ['muKinetic=0.3', { muStatic: 0.5, muKinetic: 0.3 }],
  ['scene=half-pipe&muKinetic=0.1', { muStatic: 0.1, muKinetic: 0.1 }],
])('%s names one friction, and the other follows it', (address, parameters) => {
  const state = readAddress(address)
  expect(state.parameters).toMatchObject(parameters)
  expect(readAddress(writeAddress(state))).toEqual(state)
})

test('static friction below kinetic, both named, is refused', () => {
  expect(() => readAddress('muStatic=0.1&muKinetic=0.2')).toThrow(
    /^parameters.muStatic: 0.1 is less than muKinetic, 0.2;/,
  )
})

test('the ids of all lists are different: a word tells which list it is of', () => {
  const ids = [frameClocks, timesteps, integrators, stoppings].flatMap((list) =>
    list.map(({ id }) => id as string),
  )
  expect(new Set([...ids, 'look', 'hidden']).size).toBe(ids.length + 2)
})

describe('there and back again', () => {
  test('with every entry of every list', () => {
    for (const values of methods()) {
      const state = changed(opening, { kind: 'runner', index: 0, values })
      expect(readAddress(writeAddress(state))).toEqual(state)
    }
  })

  test('with many states by chance, also as a browser encodes them', () => {
    const random = generator(1)
    for (let i = 0; i < samples(200, 5000); i++) {
      const state = randomState(random)
      const address = writeAddress(state)
      expect(readAddress(address), address).toEqual(state)
      const url = new URL(`https://any.example/#${address}`)
      expect(readAddress(url.hash.slice(1)), url.hash).toEqual(state)
      expect(readAddress(encodeURI(address)), address).toEqual(state)
    }
  })
})

describe('a bad address', () => {
  test.each([
    ['scene=rampp', 'scene: "rampp" is not one of fall, ramp'],
    ['angle=200', 'parameters.angle: 200 is not in 0…90'],
    ['angle=steep', 'parameters.angle: "steep" is not a number'],
    ['angel=20', 'parameters.angel: is not known here; did you mean angle?'],
    ['scene=fall&angle=20', 'parameters.angle: is not known here'],
    ['duration=1e9', 'duration: 1000000000 is not in'],
    ['duration=', 'duration: "" is not a number'],
    ['runners=', 'runners[0]: ""'],
    ['runners=10;rk5', 'runners[1]: "rk5" is neither a frame rate nor one of steady'],
    ['runners=0', 'runners[0].frames.fps: 0 is not in 1…10000'],
    ['runners=jitter(fps:30)', 'runners[0].frames.amount'],
    ['runners=10/fixed(step:0)', 'runners[0].timestep.step: 0 is not in'],
    ['runners=10/fixed(stepp:1)', 'runners[0].timestep.stepp: is not known here'],
    ['runners=10/fixed(step:1,draw:latex)', 'did you mean latest?'],
    ['runners=10/look(8)', 'runners[0].look: 8 is not a whole number in 0…7'],
    ['runners=1;2;3;4;5;6;7;8;9', 'runners: 9 are not in 1…8'],
    ['runners=10)/rk4', 'runners[0]: "10)'],
    ['runners=1000/per-frame(step:1)&duration=100000', 'frames, more than'],
    ['scene=half-pipe&position=9', 'is not inside the pipe'],
    ['angle=%E0%A4%A', 'parameters.angle: "\ufffd%A" is not a number'],
    ['__proto__=1', 'not known'],
  ])('%s', (address, message) => {
    expect(() => readAddress(address)).toThrow(message)
  })

  test('tells all that is wrong at once', () => {
    const address = 'scene=ramp&angle=200&speeed=3&runners=10;rk5;30/fixed(step:0)'
    try {
      readAddress(address)
      expect.unreachable()
    } catch (error) {
      const { message } = error as Error
      for (const part of ['rk5', 'speeed', '200', 'runners[2].timestep.step'])
        expect(message).toContain(part)
    }
  })
})

test('the name of a place in the page is no address', () => {
  expect(isAddress('source')).toBe(false)
  expect(isAddress('')).toBe(true)
  expect(isAddress('angle=3')).toBe(true)
})

/** A runner with each entry of each list in turn. */
function* methods(): Generator<Partial<RunnerState>> {
  const { frames, timestep } = opening.runners[0]!
  for (const { id } of integrators) yield { integrator: id }
  for (const { id } of stoppings) yield { stopping: id }
  for (const { id } of timesteps) yield { timestep: choose('timestep', id, timestep) }
  for (const { id } of frameClocks) yield { frames: choose('frames', id, frames) }
  yield { frames: { kind: 'recorded', durations: [1 / 60, 0.02, 1 / 3, 1e-5] } }
  yield { timestep: { kind: 'fixed', step: 1 / 77, maxSteps: 4, cap: 0.1, draw: 'latest' } }
}

function randomState(random: () => number): LabState {
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]!
  let state = changed(opening, { kind: 'scene', scene: pick(scenes).id })
  const names = Object.keys(state.parameters).filter((name) => !/^(position|radius)$/.test(name))
  for (const name of names) {
    // No radius is below a millimetre.
    const values = { [name]: pick([0.001 + random(), 2, 1 / 3]) }
    if (random() < 0.5) state = changed(state, { kind: 'parameters', values })
  }
  if (random() < 0.5) state = changed(state, { kind: 'duration', duration: 5 * random() })
  while (random() < 0.5 && state.runners.length < 8) state = changed(state, { kind: 'add' })
  while (random() < 0.3 && state.runners.length > 1)
    state = changed(state, { kind: 'remove', index: Math.floor(random() * state.runners.length) })
  state.runners.forEach((_, index) => {
    if (random() < 0.7) {
      const values = { ...pick([...methods()]), ...pick([...methods()]), hidden: random() < 0.2 }
      state = changed(state, { kind: 'runner', index, values })
    }
  })
  return state
}

/** The same numbers on every run (Park and Miller, 1988). */
function generator(seed: number): () => number {
  let state = seed
  return () => (state = (state * 48271) % 2147483647) / 2147483647
}
