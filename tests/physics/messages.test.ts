/** What is told to somebody whose experiment can't be run. */
import { describe, expect, it } from 'vitest'
import { ExperimentError, frameClocks, parseExperiment, scenes } from '../../src/physics/index.ts'
import { nearestName, shorten, show } from '../../src/physics/problems.ts'

/** The whole message that a value is refused with; empty for one that is taken. */
function message(value: unknown): string {
  try {
    parseExperiment(value)
    return ''
  } catch (error) {
    if (error instanceof ExperimentError) return error.message
    throw error
  }
}

const KEYS = 'scene, parameters, integrator, stopping, timestep, frames, duration, timeScale'
const SCENES = scenes.map(({ id }) => id).join(', ')
const CLOCKS = frameClocks.map(({ id }) => id).join(', ')
const recorded = (durations: unknown) => ({
  scene: 'ramp',
  frames: { kind: 'recorded', durations },
})

describe('a refusal', () => {
  it('names itself, and each problem apart', () => {
    const error = new ExperimentError([
      { path: '', message: 'is wrong' },
      { path: 'frames.fps', message: 'is too' },
    ])
    expect(error.name).toBe('ExperimentError')
    expect(error.message).toBe('The experiment: is wrong\nframes.fps: is too')
    expect(error.problems).toHaveLength(2)
  })

  it('shows twenty problems, and says how many there are of the rest', () => {
    const of = (count: number) =>
      new ExperimentError(
        Array.from({ length: count }, (_, i) => ({ path: `p${i}`, message: 'is wrong' })),
      ).message.split('\n')
    expect(of(20)).toHaveLength(20)
    expect(of(20).at(-1)).toBe('p19: is wrong')
    expect(of(21)).toHaveLength(21)
    expect(of(21).at(-1)).toBe('… and 1 more.')
  })

  it.each([
    [3, `The experiment: 3 is not an object with any of ${KEYS}`],
    [[], `The experiment: a list of 0 is not an object with any of ${KEYS}`],
    [null, `The experiment: null is not an object with any of ${KEYS}`],
    [{}, `scene: is missing; it is one of ${SCENES}`],
    [{ scene: 'loop' }, `scene: "loop" is not one of ${SCENES}`],
    [{ scene: 7 }, `scene: 7 is not one of ${SCENES}`],
    [{ scene: 'ramp', fsp: 1 }, `fsp: is not known here; known are ${KEYS}`],
    [{ scene: 'ramp', framse: 1 }, 'framse: is not known here; did you mean frames?'],
    [
      { scene: 'ramp', parameters: { angel: 1 } },
      'parameters.angel: is not known here; did you mean angle?',
    ],
    [
      { scene: 'fall', parameters: [] },
      'parameters: a list of 0 is not an object with any of gravity, mass, drag, position, speed',
    ],
    [{ scene: 'ramp', frames: 60 }, `frames: 60 is not an object with a kind, one of ${CLOCKS}`],
    [
      { scene: 'ramp', frames: null },
      `frames: null is not an object with a kind, one of ${CLOCKS}`,
    ],
    [
      { scene: 'ramp', frames: ['steady'] },
      `frames: a list of 1 is not an object with a kind, one of ${CLOCKS}`,
    ],
    [
      { scene: 'ramp', frames: { fps: 60 } },
      `frames: an object is not an object with a kind, one of ${CLOCKS}`,
    ],
    [
      { scene: 'ramp', frames: { kind: 'stedy', fps: 60 } },
      `frames.kind: "stedy" is not one of ${CLOCKS}; did you mean steady?`,
    ],
    [
      { scene: 'ramp', frames: { kind: 'steady', fsp: 60 } },
      'frames.fsp: is not known here; did you mean fps?\nframes.fps: is missing',
    ],
    [
      { scene: 'ramp', timestep: { kind: 'fixed', step: 0.1, draw: 'late' } },
      'timestep.draw: "late" is not one of latest, interpolated, extrapolated; did you mean latest?',
    ],
    [
      { scene: 'ramp', timestep: { kind: 'fixed', step: 0.1, maxSteps: 2.5 } },
      'timestep.maxSteps: 2.5 is not a whole number in 1…100000',
    ],
    [{ scene: 'ramp', duration: '2' }, 'duration: "2" is not a number'],
    [{ scene: 'ramp', duration: 1e6 + 1 }, 'duration: 1000001 is not in 0…1000000'],
    [recorded({}), 'frames.durations: an object is not a list of numbers'],
    [recorded([]), 'frames.durations: a list of 0 does not hold 1…100000 numbers'],
    [recorded([0.1, () => 1]), 'frames.durations[1]: a function is not a number'],
    [
      { scene: 'half-pipe', parameters: { position: -4, radius: 2 } },
      'parameters.position: -4 is not inside the pipe, whose radius of 2 m puts its lips at ±3.1416 m',
    ],
  ])('of %j says what was given and what is allowed', (value, expected) => {
    expect(message(value)).toBe(expected)
  })

  it('guesses names for the twenty problems that it shows, and for no more', () => {
    const slips = Object.fromEntries(Array.from({ length: 30 }, (_, i) => [`framse${i}`, i]))
    const guessed = (): number[] => {
      try {
        parseExperiment({ scene: 'ramp', ...slips })
      } catch (error) {
        const { problems } = error as ExperimentError
        return problems.flatMap(({ message }, i) => (message.includes('did you mean') ? [i] : []))
      }
      return []
    }
    expect(guessed()).toEqual(Array.from({ length: 20 }, (_, i) => i))
  })

  it('counts what a run asks for in groups of three digits', () => {
    expect(message({ scene: 'ramp', duration: 1e6, frames: { kind: 'steady', fps: 12 } })).toBe(
      'duration: 1000000 s asks for 12 000 000 frames, more than 1 000 000; shorten it or lower the frame rate'.replaceAll(
        /(?<=\d) (?=\d{3})/g,
        '\u202f',
      ) +
        '\ntimestep.step: asks for 12\u202f000\u202f000 steps, more than 5\u202f000\u202f000; lengthen the step or shorten the duration',
    )
  })

  it('meets a start at the very lip of the pipe, which is off it', () => {
    const start = (position: number) => ({
      scene: 'half-pipe',
      parameters: { position, radius: 2 },
    })
    expect(message(start(Math.PI))).toMatch(/^parameters.position: 3.1415926\d* is not inside/)
    expect(message(start(-Math.PI))).toMatch(/^parameters.position: -3.1415926\d* is not inside/)
    expect(message(start(Math.PI * (1 - Number.EPSILON)))).toBe('')
  })

  it('comes one step beyond the bounds, not at them', () => {
    const steady = (duration: number, fps: number) => ({
      scene: 'ramp',
      duration,
      frames: { kind: 'steady', fps },
    })
    expect(message(steady(1000, 1000))).toBe('')
    expect(message(steady(1000.001, 1000))).toMatch(/^duration: /)
    const fixed = (duration: number) => ({
      scene: 'ramp',
      duration,
      timestep: { kind: 'fixed', step: 1 / 1024 / 1024, maxSteps: 100_000 },
    })
    expect(message(fixed(5e6 / 1024 / 1024))).toBe('')
    expect(message(fixed(5.1e6 / 1024 / 1024))).toMatch(/^timestep.step: /)
    expect(message(recorded(new Array(100_000).fill(0.01)))).toBe('')
    expect(message(recorded(new Array(100_001).fill(0.01)))).toMatch(/1…100000 numbers/)
    expect(message({ scene: 'ramp', parameters: { angle: 90, mass: 1e-9 } })).toBe('')
  })
})

describe('a value in a message', () => {
  it.each([
    ['ramp', '"ramp"'],
    [[1, 2, 3], 'a list of 3'],
    [{ a: 1 }, 'an object'],
    [null, 'null'],
    [undefined, 'undefined'],
    [() => 1, 'a function'],
    [-0, '-0'],
    [0, '0'],
    [1.5, '1.5'],
    [10n, '10'],
    [Symbol('angle'), 'Symbol(angle)'],
    ['x'.repeat(50), `"${'x'.repeat(40)}…"`],
  ])('%o is %s', (value, expected) => {
    expect(show(value)).toBe(expected)
  })

  it('is cut after forty characters, each whole', () => {
    expect(shorten('x'.repeat(40))).toBe('x'.repeat(40))
    expect(shorten('x'.repeat(41))).toBe(`${'x'.repeat(40)}…`)
    expect(shorten('🤖'.repeat(40))).toBe('🤖'.repeat(40))
    expect(shorten('🤖'.repeat(41))).toBe(`${'🤖'.repeat(40)}…`)
  })
})

describe('the nearest name', () => {
  it.each([
    // Slips of the pen: a letter changed, left out, put in, two swapped.
    ['raxp', ['fall', 'ramp'], 'ramp'],
    ['rmp', ['fall', 'ramp'], 'ramp'],
    ['rammp', ['fall', 'ramp'], 'ramp'],
    ['rapm', ['fall', 'ramp'], 'ramp'],
    ['RAMP', ['fall', 'ramp'], 'ramp'],
    ['mustatic', ['muKinetic', 'muStatic'], 'muStatic'],
    // Two letters in a short name may be wrong, half of them in a long one.
    ['xyp', ['abp'], 'abp'],
    ['xyz', ['abc'], undefined],
    ['abcdwxyz', ['abcdefgh'], 'abcdefgh'],
    ['abcvwxyz', ['abcdefgh'], undefined],
    // Part of a name, unless it is a letter or two.
    ['kinetic', ['mass', 'muKinetic'], 'muKinetic'],
    ['Kin', ['muKinetic'], 'muKinetic'],
    ['ki', ['muKinetic'], undefined],
    // The nearest of several, the first of two alike.
    ['abcx', ['abyz', 'abcd'], 'abcd'],
    ['abcx', ['abcy', 'abcd'], 'abcy'],
    ['', ['ab', 'abc'], 'ab'],
  ])('to %j among %j is %j', (written, known, expected) => {
    expect(nearestName(written, known)).toBe(expected)
  })

  it('is not looked for where what was written is longer than a name', () => {
    expect(nearestName('x'.repeat(40), ['x'.repeat(39)])).toBe('x'.repeat(39))
    expect(nearestName('x'.repeat(41), ['x'.repeat(40)])).toBeUndefined()
  })
})
