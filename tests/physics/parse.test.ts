import { describe, expect, it } from 'vitest'
import {
  ExperimentError,
  parseExperiment,
  scenes,
  simulate,
  stoppings,
} from '../../src/physics/index.ts'

/** The error that a value is refused with. */
function refusal(value: unknown): ExperimentError {
  try {
    parseExperiment(value)
  } catch (error) {
    if (error instanceof ExperimentError) return error
    throw error
  }
  throw new Error(`${JSON.stringify(value)} was not refused`)
}

const problems = (value: unknown) =>
  Object.fromEntries(refusal(value).problems.map(({ path, message }) => [path, message]))

describe('parseExperiment', () => {
  it('fills in what is left out', () => {
    expect(parseExperiment({ scene: 'ramp', parameters: { angle: 20 } })).toEqual({
      scene: 'ramp',
      parameters: {
        angle: 20,
        muStatic: 0.3,
        muKinetic: 0.2,
        gravity: 9.81,
        mass: 1,
        position: 0,
        speed: 0,
      },
      integrator: 'velocity-verlet',
      stopping: 'located',
      timestep: { kind: 'variable' },
      frames: { kind: 'steady', fps: 60 },
      duration: 2,
      timeScale: 1,
    })
  })

  it('takes its own result, through JSON, as it is', () => {
    for (const { id } of scenes) {
      const whole = parseExperiment({
        scene: id,
        timestep: { kind: 'fixed', step: 0.01 },
        frames: { kind: 'jitter', fps: 50, amount: 0.5, seed: 9 },
      })
      expect(parseExperiment(JSON.parse(JSON.stringify(whole)))).toEqual(whole)
    }
  })

  it('names the path, what was given and what is allowed', () => {
    expect(refusal({ scene: 'ramp', frames: { kind: 'steady', fps: 0 } }).message).toBe(
      'frames.fps: 0 is not in 1…10000',
    )
  })

  it('lists every problem at once', () => {
    expect(
      problems({
        scene: 'ramp',
        parameters: { angle: 100, mass: 0, muStatc: 0.3 },
        integrator: 'rk5',
        stopping: 7,
        timestep: { kind: 'fixed' },
        frames: { kind: 'jitter', fps: '60', amount: 2, seed: 1.5 },
        duration: -1,
        fps: 60,
      }),
    ).toEqual({
      'parameters.angle': '100 is not in 0…90',
      'parameters.mass': '0 is not in 1e-9…1000000000',
      'parameters.muStatc': 'is not known here; did you mean muStatic?',
      integrator: expect.stringContaining('"rk5" is not one of explicit-euler,') as string,
      stopping: `7 is not one of ${stoppings.map(({ id }) => id).join(', ')}`,
      'timestep.step': 'is missing',
      'frames.fps': '"60" is not a number',
      'frames.amount': '2 is not in 0…1',
      'frames.seed': '1.5 is not a whole number in 0…4294967295',
      duration: '-1 is not in 0…1000000',
      fps: expect.stringContaining('is not known here') as string,
    })
  })

  it.each([undefined, null, 3, 'ramp', [], () => 1, NaN])(
    'refuses %s, which is no experiment',
    (value) => {
      expect(refusal(value).message).toMatch(/^The experiment: .* is not an object/)
    },
  )

  it.each(['parameters', 'integrator', 'stopping', 'timestep', 'frames', 'duration'])(
    'takes null for no %s: only what is left out has a default',
    (key) => {
      expect(() => parseExperiment({ scene: 'ramp', [key]: null })).toThrow(
        new RegExp(`^${key}: null `),
      )
      const left = parseExperiment({ scene: 'ramp', [key]: undefined })
      expect(left).toEqual(parseExperiment({ scene: 'ramp' }))
    },
  )

  it('suggests the nearest name', () => {
    expect(problems({ scene: 'half pipe' }).scene).toMatch(/did you mean half-pipe\?/)
    expect(problems({ scene: 'ramp', integrator: 'verlet' }).integrator).toMatch(
      /did you mean velocity-verlet\?/,
    )
    expect(problems({ scene: 'ramp', framse: {} }).framse).toMatch(/did you mean frames\?/)
    expect(
      problems({ scene: 'ramp', timestep: { kind: 'fixd', step: 1 } })['timestep.kind'],
    ).toMatch(/did you mean fixed\?/)
    expect(
      problems({ scene: 'ramp', parameters: { zzzzzzzzz: 1 } })['parameters.zzzzzzzzz'],
    ).toMatch(/known are angle/)
  })

  it('a missing scene is the one problem that has no default', () => {
    expect(problems({})).toEqual({
      scene: `is missing; it is one of ${scenes.map(({ id }) => id).join(', ')}`,
    })
  })

  it('parameters belong to their scene', () => {
    expect(problems({ scene: 'ramp', parameters: { stiffness: 3 } })).toHaveProperty([
      'parameters.stiffness',
    ])
  })

  it('refuses a start beyond the lip of the pipe, and says where that is', () => {
    expect(refusal({ scene: 'half-pipe', parameters: { radius: 1 } }).message).toMatch(
      /^parameters.position: 1.6 .*±1.5708 m/,
    )
  })

  it('only an object’s own properties count', () => {
    const inherited = Object.create({ scene: 'ramp' }) as unknown
    expect(problems(inherited)).toHaveProperty('scene')
    const poisoned: unknown = JSON.parse(
      '{"scene":"ramp","__proto__":{"duration":1},"parameters":{"__proto__":{"mass":2}}}',
    )
    expect(Object.keys(problems(poisoned)).sort()).toEqual(['__proto__', 'parameters.__proto__'])
  })

  it('refuses lists that are empty, too long or hold anything but numbers', () => {
    const recorded = (durations: unknown) =>
      problems({ scene: 'ramp', frames: { kind: 'recorded', durations } })
    expect(recorded([])['frames.durations']).toMatch(/a list of 0 does not hold 1…/)
    expect(recorded(new Array(1e6).fill(0.01))['frames.durations']).toMatch(
      /a list of 1000000 does not hold/,
    )
    expect(recorded([0.01, 'x', -1])).toEqual({
      'frames.durations[1]': '"x" is not a number',
      'frames.durations[2]': '-1 is not in 0.00001…60',
    })
    expect(recorded('0.01')['frames.durations']).toBe('"0.01" is not a list of numbers')
    // A hole in a list is undefined.
    expect(recorded(Object.assign(new Array<number>(2), { 1: 0.01 }))).toEqual({
      'frames.durations[0]': 'undefined is not a number',
    })
  })

  it('shows what was given in a few words, however long it is', () => {
    const { message } = refusal({ scene: 'x'.repeat(1e6), ['y'.repeat(1e5)]: 1 })
    expect(message.length).toBeLessThan(400)
    const many = Object.fromEntries(Array.from({ length: 1000 }, (_, i) => [`unknown${i}`, i]))
    expect(refusal({ scene: 'ramp', ...many }).message).toMatch(/and 980 more\.$/)
    expect(refusal({ scene: '\ud83e' }).message).toBeTruthy()
  })

  it('turns −0 into 0 and refuses what is not finite', () => {
    expect(
      Object.is(parseExperiment({ scene: 'ramp', parameters: { speed: -0 } }).parameters.speed, 0),
    ).toBe(true)
    for (const speed of [NaN, Infinity, -Infinity, 1e308])
      expect(problems({ scene: 'ramp', parameters: { speed } })).toHaveProperty([
        'parameters.speed',
      ])
    expect(parseExperiment({ scene: 'ramp', parameters: { speed: 5e-324 } }).parameters.speed).toBe(
      5e-324,
    )
  })

  it('refuses more frames or steps than can be run, with the figure', () => {
    expect(
      problems({ scene: 'ramp', duration: 1e5, frames: { kind: 'steady', fps: 100 } }).duration,
    ).toMatch(/asks for 10\s000\s000 frames, more than 1\s000\s000/)
    expect(
      problems({ scene: 'ramp', duration: 100, timestep: { kind: 'fixed', step: 1e-6 } })[
        'timestep.step'
      ],
    ).toMatch(/asks for 100\s000\s000 steps, more than 5\s000\s000/)
    // The very bounds are allowed.
    expect(
      parseExperiment({ scene: 'ramp', duration: 1e6, frames: { kind: 'steady', fps: 1 } })
        .duration,
    ).toBe(1e6)
    expect(
      parseExperiment({ scene: 'ramp', duration: 5, timestep: { kind: 'fixed', step: 1e-6 } })
        .duration,
    ).toBe(5)
  })

  it('guards every way in', () => {
    expect(() => simulate({ scene: 'ramp', duration: NaN })).toThrow(ExperimentError)
  })

  it('knows a range, a slider within it and a start within that, for every number in every list', () => {
    for (const { parameters } of scenes)
      for (const [name, { min, max, slider, initial }] of Object.entries(parameters)) {
        expect(slider.from, name).toBeGreaterThanOrEqual(min)
        expect(slider.to, name).toBeLessThanOrEqual(max)
        expect(initial >= slider.from && initial <= slider.to, name).toBe(true)
      }
  })
})
