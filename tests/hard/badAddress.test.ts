import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { readAddress, writeAddress } from '../../src/lab/state/address.ts'
import { checked, experimentOf, MOST_RUNNERS } from '../../src/lab/state/check.ts'
import type { LabState } from '../../src/lab/state/state.ts'
import { ExperimentError, parseExperiment } from '../../src/physics/index.ts'
import { experiments } from './experiments.ts'
import { check } from './runs.ts'

const states: fc.Arbitrary<LabState> = fc
  .tuple(
    experiments('wild'),
    fc.array(fc.tuple(experiments('wild'), fc.nat(MOST_RUNNERS - 1), fc.boolean()), {
      minLength: 1,
      maxLength: MOST_RUNNERS,
    }),
  )
  .map(([{ scene, parameters, duration, timeScale }, runners]) => ({
    scene,
    parameters,
    // The runners come from other runs, whose clocks may ask for too much in this one's time.
    duration: Math.min(duration, 1),
    timeScale,
    runners: runners.map(([{ integrator, stopping, timestep, frames }, paletteIndex, hidden]) => ({
      ...{ integrator, stopping, timestep, frames },
      ...{ paletteIndex, hidden },
    })),
  }))
  .filter((state) => state.runners.every((runner) => runs(() => experimentOf(state, runner))))

function runs(experiment: () => unknown): boolean {
  try {
    parseExperiment(experiment())
    return true
  } catch {
    return false
  }
}

// What is put between the letters of an address.
const pieces = fc.oneof(
  fc.constantFrom(
    ...['&', '=', ';', '/', '(', ')', ',', ':', '+', '#', '%', '%E0', '%00', ' ', '-', '−', '.'],
    ...['__proto__', 'constructor=1&', 'toString', 'scene=', 'runners=', 'duration=', 'hidden'],
    ...['1e308', '-0', '5e-324', 'NaN', 'Infinity', '0x10', '1/0', '0/0', '９', '\ud83e', '🤖'],
    ...['<img src=x onerror=alert(1)>', '"><script>', '4n-m9999', 'recorded(durations:', 'jitter('],
  ),
  fc.string({ unit: 'binary', maxLength: 5 }),
)

type Edit = { at: number; cut: number; put: string }
const edits = fc.array(fc.record({ at: fc.nat(), cut: fc.nat({ max: 8 }), put: pieces }), {
  minLength: 1,
  maxLength: 4,
})

function edited(text: string, all: readonly Edit[]): string {
  return all.reduce((before, { at, cut, put }) => {
    const place = at % (before.length + 1)
    return before.slice(0, place) + put + before.slice(place + cut)
  }, text)
}

describe('mutated addresses', () => {
  it('are each a lab that runs, which says so again, or refused for people', () => {
    let refused = 0
    check(1, fc.tuple(states, edits), ([state, all]) => {
      const address = edited(writeAddress(state), all)
      let read: LabState
      try {
        read = readAddress(address)
      } catch (error) {
        refused++
        expectRefusal(error)
        return
      }
      expect(checked(read)).toEqual(read)
      expect(readAddress(writeAddress(read))).toEqual(read)
    })
    // Most edits spoil an address; were all taken, nothing would be looked at.
    expect(refused).toBeGreaterThan(500)
  })

  // Each is wrong on its own, at a path that is known.
  const spoilt = fc.constantFrom<[field: string, path: string]>(
    ['angel=3', 'parameters.angel'],
    ['__proto__=3', 'parameters.__proto__'],
    ['constructor=3', 'parameters.constructor'],
    ['toString=3', 'parameters.toString'],
    ['=', 'parameters.'],
    ['<b>=1', 'parameters.<b>'],
    ['%F0%9F%A4%96=1', 'parameters.🤖'],
  )

  it('are refused with every wrong path and no other', () => {
    const lists = fc.tuple(
      states,
      fc.uniqueArray(spoilt, { maxLength: 3 }),
      fc.constantFrom<[string, string] | undefined>(
        undefined,
        ['-1', 'duration'],
        ['Infinity', 'duration'],
        ['１', 'duration'],
        ['', 'duration'],
        ['1/0', 'duration'],
      ),
      fc.uniqueArray(
        fc.constantFrom<[word: string, path: string]>(
          ['rk5', ''],
          ['0', '.frames.fps'],
          ['1e308', '.frames.fps'],
          ['fixed(step:0)', '.timestep.step'],
          ['fixed(step:1,steps:2)', '.timestep.steps'],
          ['capped', '.timestep.cap'],
          ['look(9)', '.look'],
          ['look(-0.5)', '.look'],
        ),
        { maxLength: 3, selector: ([, path]) => path.split('.')[1] ?? '' },
      ),
    )
    check(0.2, lists, ([state, fields, duration, words]) => {
      const runner = state.runners.length - 1
      const expected = fields.map(([, path]) => path)
      // So short, and no faster than its frames, any of them can be run.
      let address = writeAddress({ ...state, duration: 0.123, timeScale: 1 })
      if (!address.includes('runners=')) return
      if (words.length > 0) {
        // The runners stand last, and the last word of a kind is the one that counts.
        address += words.map(([word]) => `/${word}`).join('')
        expected.push(...words.map(([, path]) => `runners[${runner}]${path}`))
      }
      if (duration) {
        address = address.replace('duration=0.123', `duration=${duration[0]}`)
        expected.push(duration[1])
      }
      address = [...fields.map(([field]) => field), address].join('&')
      if (expected.length === 0) {
        readAddress(address)
        return
      }
      try {
        readAddress(address)
      } catch (error) {
        const paths = expectRefusal(error)
        expect(paths.sort()).toEqual(expected.sort())
        return
      }
      expect.unreachable(address)
    })
  })
})

function expectRefusal(error: unknown): string[] {
  if (!(error instanceof ExperimentError)) throw error
  expect(error.problems.length).toBeGreaterThan(0)
  expect(error.message.length).toBeLessThan(21 * 600)
  return error.problems.map(({ path }) => path)
}

describe('the work of reading an address', () => {
  it('one that is too long is not read', () => {
    const address = 'a=1&'.repeat(20_000)
    expect(() => readAddress(address)).toThrow(/^address: has 80000 characters, more than the/)
  })

  it('runners that are too many are counted, not read', () => {
    try {
      readAddress(`runners=${';rk5'.repeat(10_000)}`)
      expect.unreachable()
    } catch (error) {
      const paths = (error as ExperimentError).problems.map(({ path }) => path)
      expect(paths).toHaveLength(MOST_RUNNERS + 1)
      expect((error as ExperimentError).message).toContain('runners: 10001 are not in 1…8')
    }
  })

  it('a name that stands there twice is told, not overruled', () => {
    expect(() => readAddress('angle=10&angle=20')).toThrow(/^angle: stands there twice$/)
  })
})
