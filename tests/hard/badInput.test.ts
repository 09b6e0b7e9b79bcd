import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  ExperimentError,
  frameClocks,
  integrators,
  limits,
  parseExperiment,
  scenes,
  simulate,
  stoppings,
  timesteps,
} from '../../src/physics/index.ts'
import type {
  Experiment,
  Option,
  Options,
  ResolvedExperiment,
  Scene,
} from '../../src/physics/index.ts'
import { experiments, work } from './experiments.ts'
import { check } from './runs.ts'

type Json = Record<string, unknown>

// What nobody should send, at any place.
const poison: fc.Arbitrary<unknown> = fc.oneof(
  fc.constantFrom<unknown>(
    null,
    undefined,
    true,
    -0,
    5e-324,
    -5e-324,
    1e308,
    -1e308,
    NaN,
    Infinity,
    -Infinity,
    2 ** 53,
    '60',
    '1e3',
    '',
    '\ud83e',
    '\udd16\ud83e',
    '🤖'.repeat(50_000),
    '__proto__',
    'constructor',
    [],
    {},
    [[]],
    [1, '2'],
    10n,
    Symbol('angle'),
    () => 1,
    new Date(0),
    new Map([['kind', 'steady']]),
    Object.create({ kind: 'steady', fps: 60 }),
    JSON.parse('{"__proto__":{"kind":"steady"},"fps":60}'),
    { kind: 'steady', fps: 60, toString: 1 },
    { kind: '__proto__' },
    { kind: 'recorded', durations: [] },
    { kind: 'recorded', durations: new Array(20_000).fill(0.01) },
    { kind: 'recorded', durations: { length: 3 } },
    // Holes are undefined, and there are a billion of them.
    { kind: 'recorded', durations: new Array(1e9) },
    nested(10_000),
  ),
  fc.anything(),
  fc.double(),
)

function nested(depth: number): unknown {
  let value: unknown = 1
  for (let i = 0; i < depth; i++) value = i % 2 ? [value] : { frames: value }
  return value
}

const keys = fc.oneof(
  fc.constantFrom(
    '__proto__',
    'constructor',
    'toString',
    'hasOwnProperty',
    'kind',
    'Scene',
    'fsp',
    'μ',
    '\ud83e',
    '',
    '🤖'.repeat(1000),
    'x'.repeat(100_000),
  ),
  fc.string(),
)

type Change = { at: number; how: 'replace' | 'remove' | 'add'; value: unknown; key: string }
const changes = fc.array(
  fc.record({
    at: fc.nat(),
    how: fc.constantFrom('replace' as const, 'remove' as const, 'add' as const),
    value: poison,
    key: keys,
  }),
  { minLength: 1, maxLength: 4 },
)

/** Every object and list in a value, with each of its keys: the places where something can be changed. */
function places(value: unknown, found: [Json, string][] = []): [Json, string][] {
  if (typeof value !== 'object' || value === null) return found
  for (const key of Object.keys(value)) {
    found.push([value as Json, key])
    if (found.length < 100) places((value as Json)[key], found)
  }
  return found
}

function mutate(experiment: ResolvedExperiment, all: readonly Change[]): unknown {
  const whole = { root: structuredClone(experiment) as unknown }
  for (const { at, how, value, key } of all) {
    const open = places(whole)
    const [owner, name] = open[at % open.length]!
    if (how === 'replace') owner[name] = value
    else if (how === 'remove' && owner !== whole) Reflect.deleteProperty(owner, name)
    else if (how === 'add' && !Array.isArray(owner) && owner !== whole)
      Object.defineProperty(owner, key, {
        value,
        enumerable: true,
        configurable: true,
        writable: true,
      })
  }
  return whole.root
}

const KEYS = ['scene', 'parameters', 'integrator', 'stopping', 'timestep', 'frames', 'duration']
const parametersOfAll: Options = Object.assign({}, ...scenes.map(({ parameters }) => parameters))

/** What only goes wrong together: parameters that conflict, and a run that is too long. */
const TOGETHER = ['parameters.position', 'parameters.muStatic', 'duration', 'timestep.step']

/**
 * The paths at which a value is wrong, by the descriptions of the lists alone: what `parseExperiment` has to name, no
 * more and no less. What only goes wrong together is not among them.
 */
function wrongPaths(value: unknown): string[] {
  const wrong: string[] = []
  if (!isObject(value)) return ['']
  unknownKeys('', value, KEYS, wrong)
  const get = (key: string, usual?: unknown): unknown =>
    Object.hasOwn(value, key) && value[key] !== undefined ? value[key] : usual
  const scene = (scenes as readonly Scene[]).find(({ id }) => id === get('scene'))
  if (!scene) wrong.push('scene')
  const parameters = get('parameters', {})
  // Under an unknown scene a parameter is right that is right in some scene.
  const known = scene?.parameters ?? parametersOfAll
  if (isObject(parameters)) {
    unknownKeys('parameters.', parameters, Object.keys(known), wrong)
    wrongOptions('parameters.', parameters, known, wrong)
  } else wrong.push('parameters')
  for (const [key, list] of [
    ['integrator', integrators],
    ['stopping', stoppings],
  ] as const) {
    const given = get(key, list[0].id)
    if (!list.some(({ id }) => id === given)) wrong.push(key)
  }
  for (const [key, list, usual] of [
    ['timestep', timesteps, { kind: 'variable' }],
    ['frames', frameClocks, { kind: 'steady', fps: 60 }],
  ] as const) {
    const given = get(key, usual)
    if (!isObject(given) || !Object.hasOwn(given, 'kind')) {
      wrong.push(key)
      continue
    }
    const chosen = list.find(({ id }) => id === given.kind)
    if (!chosen) {
      wrong.push(`${key}.kind`)
      continue
    }
    unknownKeys(`${key}.`, given, ['kind', ...Object.keys(chosen.options)], wrong)
    wrongOptions(`${key}.`, given, chosen.options, wrong)
  }
  const duration = get('duration', 0)
  if (!(typeof duration === 'number' && duration >= 0 && duration <= limits.duration))
    wrong.push('duration')
  return wrong
}

const isObject = (value: unknown): value is Json =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

function unknownKeys(path: string, value: Json, known: readonly string[], wrong: string[]): void {
  for (const key of Object.keys(value))
    if (!known.includes(key)) {
      const characters = Array.from(key)
      wrong.push(path + (characters.length > 40 ? `${characters.slice(0, 40).join('')}…` : key))
    }
}

function wrongOptions(path: string, value: Json, options: Options, wrong: string[]): void {
  for (const [key, option] of Object.entries(options)) {
    if (!Object.hasOwn(value, key)) {
      if (!option.optional) wrong.push(path + key)
    } else wrongValue(path + key, value[key], option, wrong)
  }
}

function wrongValue(path: string, value: unknown, option: Option, wrong: string[]): void {
  const inRange = (x: unknown, whole = false): boolean =>
    option.type !== 'choice' &&
    typeof x === 'number' &&
    x >= option.min &&
    x <= option.max &&
    (!whole || Number.isInteger(x))
  if (option.type === 'choice') {
    if (!(typeof value === 'string' && option.choices.includes(value))) wrong.push(path)
  } else if (option.type === 'number') {
    if (!inRange(value, option.integer)) wrong.push(path)
  } else if (!Array.isArray(value) || value.length < 1 || value.length > option.maxLength)
    wrong.push(path)
  else for (let i = 0; i < value.length; i++) if (!inRange(value[i])) wrong.push(`${path}[${i}]`)
}

describe('ten thousand mutated experiments', () => {
  it('are each valid and run, or refused with every wrong path and no other', () => {
    check(1, fc.tuple(experiments('wild'), changes), ([experiment, all]) => {
      const value = mutate(experiment, all)
      const expected = wrongPaths(value)
      let parsed: ResolvedExperiment
      try {
        parsed = parseExperiment(value)
      } catch (error) {
        expectRefusal(error, expected)
        return
      }
      expect(expected).toEqual([])
      // What it takes, it takes again, from JSON.
      expect(parseExperiment(JSON.parse(JSON.stringify(parsed)))).toEqual(parsed)
      const asked = work(parsed)
      expect(asked.frames).toBeLessThanOrEqual(limits.frames)
      expect(asked.steps).toBeLessThanOrEqual(limits.steps)
      // A changed duration may ask for a million frames, which is allowed and takes a while.
      if (asked.frames <= 2000 && asked.steps <= 5000)
        expect(simulate(value as Experiment).s.every(Number.isFinite)).toBe(true)
    })
  })
})

function expectRefusal(error: unknown, expected: readonly string[]): void {
  if (!(error instanceof ExperimentError)) throw error
  const paths = error.problems.map(({ path }) => path)
  expect(paths.length).toBeGreaterThan(0)
  const alone = paths.filter((path) => expected.includes(path) || !TOGETHER.includes(path))
  expect(alone.sort()).toEqual([...expected].sort())
  // What is valid in itself may take too much work, of which the duration is to blame.
  for (const { path, message } of error.problems)
    if (message.includes('evaluations')) expect(path).toBe('duration')
  // For people: a line for each of the first twenty, none of them long, whatever was given.
  expect(error.message.split('\n').length).toBeLessThanOrEqual(400)
  expect(error.message.length).toBeLessThan(21 * 400)
}

describe('the work of reading', () => {
  /** How often an object's properties are read, listed or asked for. */
  function counted<T extends object>(value: T): { value: T; count: () => number } {
    let count = 0
    const handler = Object.fromEntries(
      (['get', 'has', 'ownKeys', 'getOwnPropertyDescriptor'] as const).map((trap) => [
        trap,
        (...args: unknown[]) => {
          count++
          return (Reflect[trap] as (...args: unknown[]) => unknown)(...args)
        },
      ]),
    )
    return { value: new Proxy(value, handler), count: () => count }
  }

  it('a list that is too long is not looked through', () => {
    for (const length of [10_001, 1e6, 1e9]) {
      const { value: durations, count } = counted(new Array<number>(length))
      const read = () => parseExperiment({ scene: 'ramp', frames: { kind: 'recorded', durations } })
      expect(read).toThrow(/does not hold 1…10000 numbers/)
      expect(count()).toBeLessThan(20)
    }
  })

  it('a list of the longest allowed is read once', () => {
    const { value: durations, count } = counted(new Array<number>(10_000).fill(0.001))
    parseExperiment({ scene: 'ramp', frames: { kind: 'recorded', durations } })
    // An index asks whether it is there and for its value.
    expect(count()).toBeLessThan(3 * 10_000)
  })

  it('a deep value is not descended into', () => {
    const { value, count } = counted({ deep: nested(100_000) })
    expect(() => parseExperiment({ scene: 'ramp', parameters: { angle: value } })).toThrow(
      /^parameters.angle: an object is not a number$/,
    )
    expect(count()).toBe(0)
    expect(() => parseExperiment(nested(100_000))).toThrow(ExperimentError)
  })

  it('an experiment is not changed, and what it becomes shares nothing with it', () => {
    const given = Object.freeze({
      scene: 'ramp',
      parameters: Object.freeze({ angle: 20 }),
      frames: Object.freeze({ kind: 'recorded', durations: Object.freeze([0.01, 0.02]) }),
    })
    const parsed = parseExperiment(given)
    expect(parsed.parameters).not.toBe(given.parameters)
    expect((parsed.frames as { durations: unknown }).durations).not.toBe(given.frames.durations)
  })

  it('text of characters of two units is cut like any other', () => {
    for (const length of [39, 40, 41, 79, 80, 81, 100_000]) {
      let message = ''
      try {
        parseExperiment({ scene: '🤖'.repeat(length), ['🤖'.repeat(length)]: 1 })
      } catch (error) {
        message = (error as Error).message
      }
      const longest = /🤖+/gu
      for (const [run] of message.matchAll(longest))
        expect(Array.from(run).length).toBe(Math.min(40, length))
    }
  })

  it.each([
    // Two million steps in frames that are all in the first minute.
    { frames: { kind: 'hitch', fps: 1000, every: 60, length: 60 }, step: 1e-7, duration: 60 },
    { frames: { kind: 'hitch', fps: 1000, every: 60, length: 60 }, step: 1e-5, duration: 59 },
    {
      frames: { kind: 'recorded', durations: [...new Array<number>(9999).fill(1e-3), 60] },
      step: 1e-6,
      duration: 10,
    },
  ])('no run takes more steps than are allowed: $frames.kind', ({ frames, step, duration }) => {
    expect(() =>
      parseExperiment({ scene: 'ramp', timestep: { kind: 'fixed', step }, frames, duration }),
    ).toThrow(/timestep.step: asks for [\d\s]+ steps, more than 5\s000\s000/)
  })

  it('the figure of a run that is far too long has all its digits', () => {
    expect(() =>
      parseExperiment({
        scene: 'ramp',
        duration: 1e6,
        frames: { kind: 'recorded', durations: [1e-5] },
        timestep: { kind: 'substeps', step: 1e-7 },
      }),
    ).toThrow(/asks for 100\s000\s000\s001 frames[^]*asks for 10\s100\s000\s000\s001 steps/)
  })
})
