/** Values that misbehave while they are read, or change afterwards. */
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { ExperimentError, parseExperiment, scenes } from '../../src/physics/index.ts'
import { parseForRun } from '../../src/physics/parse.ts'

type Json = Record<string, unknown>

/** The problems that a value is refused with, by path. */
function problems(value: unknown, parse: (value: unknown) => unknown = parseExperiment): Json {
  try {
    parse(value)
  } catch (error) {
    if (!(error instanceof ExperimentError)) throw error
    return Object.fromEntries(error.problems.map(({ path, message }) => [path, message]))
  }
  return {}
}

const whole = (): Json => ({
  scene: 'ramp',
  parameters: { angle: 20, muStatic: 0.4, muKinetic: 0.3 },
  integrator: 'rk4',
  stopping: 'clamped',
  timestep: { kind: 'fixed', step: 0.01, maxSteps: 7 },
  frames: { kind: 'recorded', durations: [0.01, 0.02] },
  duration: 1,
})

/** Every place in an experiment, as the keys that lead there. */
const places: readonly (readonly string[])[] = [
  ...Object.keys(whole()).map((key) => [key]),
  ...['angle', 'muStatic', 'muKinetic'].map((key) => ['parameters', key]),
  ...['kind', 'step', 'maxSteps'].map((key) => ['timestep', key]),
  ...['kind', 'durations'].map((key) => ['frames', key]),
  ...['0', '1'].map((key) => ['frames', 'durations', key]),
]

/** The object that holds a place of an experiment. */
function owner(experiment: Json, place: readonly string[]): Json {
  return place.slice(0, -1).reduce((at, key) => at[key] as Json, experiment)
}

const pathOf = (place: readonly string[]) => place.join('.').replace(/\.(\d)$/, '[$1]')

const anything = [new Error('boom'), 'boom', null, undefined, 10n, Symbol('boom'), { toString: 1 }]

const traps = ['get', 'ownKeys', 'getOwnPropertyDescriptor', 'has', 'getPrototypeOf'] as const

/** A Proxy that throws in those traps. */
function hostile(target: object, which: readonly (typeof traps)[number][], thrown: unknown) {
  const fail = () => {
    throw thrown
  }
  return new Proxy(target, Object.fromEntries(which.map((trap) => [trap, fail])))
}

function revoked(target: object): unknown {
  const { proxy, revoke } = Proxy.revocable(target, {})
  revoke()
  return proxy
}

describe('a value that can’t be read', () => {
  it.each(places.map((place) => ({ path: pathOf(place), place })))(
    'is the one problem, and named: a getter at $path that throws',
    ({ path, place }) => {
      for (const thrown of anything) {
        const experiment = whole()
        Object.defineProperty(owner(experiment, place), place.at(-1)!, {
          enumerable: true,
          get: () => {
            throw thrown
          },
        })
        const found = problems(experiment)
        expect(Object.keys(found)).toEqual([path])
        expect(found[path]).toMatch(/^could not be read: /)
        expect(Object.keys(problems(experiment, parseForRun))).toEqual([path])
      }
    },
  )

  it('says what the getter threw', () => {
    const experiment = {
      get scene() {
        throw new Error('boom')
      },
    }
    expect(problems(experiment)).toEqual({ scene: 'could not be read: the error "boom"' })
  })

  it('is refused, or read, whatever a Proxy throws and wherever it stands', () => {
    const roots = [[], ...places]
    fc.assert(
      fc.property(
        fc.constantFrom(...roots),
        fc.subarray([...traps], { minLength: 1 }),
        fc.constantFrom(...anything),
        fc.constantFrom<object>({}, [], [1, 2], () => 1, new Error('x')),
        fc.boolean(),
        (place, which, thrown, stranger, own) => {
          const experiment = whole()
          const at = place.length > 0 ? owner(experiment, place) : { root: experiment }
          const key = place.at(-1) ?? 'root'
          const there = own ? (at as Json)[key] : stranger
          const target = typeof there === 'object' ? there! : stranger
          ;(at as Json)[key] = hostile(target, which, thrown)
          const value = place.length > 0 ? experiment : (at as Json).root
          // Anything but an ExperimentError comes through as it is, and fails.
          for (const path of Object.keys(problems(value)))
            expect(path.startsWith(pathOf(place.slice(0, 1)))).toBe(true)
          ;(at as Json)[key] = revoked(target)
          expect(problems(place.length > 0 ? experiment : (at as Json).root)).not.toEqual({})
        },
      ),
      { numRuns: 2000, seed: 1 },
    )
  })
})

describe('what is read', () => {
  it('is an object’s own properties, whatever its prototype', () => {
    const prototypes = [null, {}, { scene: 'fall', duration: 3 }, [], new Map(), new Error('x')]
    for (const prototype of prototypes) {
      const copy = Object.assign(Object.create(prototype) as Json, whole())
      copy.parameters = Object.assign(Object.create(prototype) as Json, copy.parameters)
      expect(parseExperiment(copy)).toEqual(parseExperiment(whole()))
    }
    class Given {
      get scene() {
        return 'ramp'
      }
    }
    expect(problems(new Given())).toHaveProperty('scene')
  })

  it('is read once, and later changes of it change nothing', () => {
    const reads = new Map<string, number>()
    const counted = (value: Json, path: string): Json =>
      new Proxy(value, {
        get(target, key) {
          const at = `${path}.${String(key)}`
          // A list is asked for its length to be shown and to be read.
          if (key !== 'length') reads.set(at, (reads.get(at) ?? 0) + 1)
          const inner = Reflect.get(target, key) as unknown
          return typeof inner === 'object' && inner !== null ? counted(inner as Json, at) : inner
        },
      })
    const given = whole()
    const parsed = parseExperiment(counted(given, ''))
    expect([...reads.values()].every((count) => count === 1)).toBe(true)
    const before = structuredClone(parsed)
    given.duration = 9
    for (const key of ['parameters', 'timestep', 'frames'])
      for (const inner of Object.keys(given[key] as Json)) (given[key] as Json)[inner] = 'changed'
    expect(parsed).toEqual(before)
  })
})

describe('every problem', () => {
  it('includes too much work, whatever else is wrong', () => {
    const found = problems({ ...whole(), integrator: 'rk5', parameters: { mas: 1 }, duration: 1e6 })
    expect(Object.keys(found).sort()).toEqual([
      'duration',
      'integrator',
      'parameters.mas',
      'timestep.step',
    ])
  })

  it('leaves out work that can’t be told', () => {
    const found = problems({ ...whole(), duration: 1e6, frames: { kind: 'steady', fps: 0 } })
    expect(Object.keys(found)).toEqual(['frames.fps'])
  })

  it('includes the parameters under an unknown scene: names of no scene, and values of none', () => {
    const parameters = { angle: 100, stiffness: 7, radius: '2', drag: 0, sped: 1, muStatic: NaN }
    const expected = ['angle', 'radius', 'sped', 'muStatic'].map((name) => `parameters.${name}`)
    for (const scene of ['loop', 7, undefined]) {
      const found = problems({ scene, parameters, duration: -1 })
      expect(Object.keys(found).sort()).toEqual(['duration', ...expected, 'scene'].sort())
      expect(found['parameters.sped']).toMatch(/did you mean speed\?/)
    }
  })

  it('includes a conflict of parameters beside what else is wrong', () => {
    const parameters = { radius: 1, position: 5 }
    const found = problems({ scene: 'half-pipe', parameters, stopping: 'brakes' })
    expect(Object.keys(found)).toEqual(['parameters.position', 'stopping'])
  })
})

describe('static and kinetic friction', () => {
  const pairs = scenes.filter(({ parameters }) => 'muStatic' in parameters)
  const mu = fc.double({ min: 0, max: 1e6, noNaN: true })
  const parse = (scene: string, parameters: Json) =>
    parseExperiment({ scene, parameters }).parameters

  it.each(pairs)('$id: both given stay as they are, or are refused with the figures', ({ id }) => {
    fc.assert(
      fc.property(mu, mu, (muStatic, muKinetic) => {
        const parameters = { muStatic, muKinetic }
        if (muStatic >= muKinetic)
          expect(parse(id, parameters)).toMatchObject({
            muStatic: muStatic + 0,
            muKinetic: muKinetic + 0,
          })
        else
          expect(problems({ scene: id, parameters })).toEqual({
            'parameters.muStatic': `${muStatic + 0} is less than muKinetic, ${muKinetic}; static friction is never below kinetic`,
          })
      }),
      { seed: 1 },
    )
  })

  it.each(pairs)('$id: where one is given, the default of the other follows it', (scene) => {
    const { id, parameters } = scene as {
      id: string
      parameters: Record<string, { initial: number }>
    }
    fc.assert(
      fc.property(mu, (value) => {
        const given = value + 0
        expect(parse(id, { muKinetic: given })).toMatchObject({
          muStatic: Math.max(parameters.muStatic!.initial, given),
          muKinetic: given,
        })
        expect(parse(id, { muStatic: given })).toMatchObject({
          muStatic: given,
          muKinetic: Math.min(parameters.muKinetic!.initial, given),
        })
      }),
      { seed: 1 },
    )
  })
})
