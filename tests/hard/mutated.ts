/** Experiments in which something is wrong. */
import fc from 'fast-check'
import type { ResolvedExperiment } from '../../src/physics/index.ts'

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

/** Lists and objects in each other. */
export function nested(depth: number): unknown {
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

export type Change = { at: number; how: 'replace' | 'remove' | 'add'; value: unknown; key: string }
/** What to change in an experiment, and into what. */
export const changes = fc.array(
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

/** An experiment with some changes. */
export function mutate(experiment: ResolvedExperiment, all: readonly Change[]): unknown {
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
