/** The bound on work, which is known before a run starts. */
import { describe, expect, it } from 'vitest'
import { ExperimentError, integrators, parseExperiment, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { parseForRun } from '../../src/physics/parse.ts'

/** The message that an experiment is refused with; empty for one that is taken. */
function refusal(experiment: unknown): string {
  try {
    parseExperiment(experiment)
  } catch (error) {
    if (error instanceof ExperimentError) return error.message
    throw error
  }
  return ''
}

const hardly = { muStatic: 1e-6, muKinetic: 1e-6 }
const spring = (parameters: object, rest: object = {}) =>
  ({ scene: 'spring', parameters: { angle: 0, position: 1, ...parameters }, ...rest }) as Experiment
const pipe = (parameters: object, rest: object = {}) =>
  ({ scene: 'half-pipe', parameters, ...rest }) as Experiment
const fast = { frames: { kind: 'steady', fps: 1000 }, duration: 1000 }

describe('work', () => {
  it('of the spring that took a minute is refused, with the figure and what to do', () => {
    // ω = 190 000/s reverses ω · 1000/π = 60.5 million times.
    expect(refusal(spring({ stiffness: 36100000038, ...hardly }, fast))).toBe(
      'duration: 1000 s asks for about 690 000 000 evaluations of the acceleration, more than 100 000 000, to locate up to 61 000 000 reversals; shorten it, slow the oscillation or choose another stopping rule'.replaceAll(
        /(?<=\d) (?=\d{3})/g,
        '\u202f',
      ),
    )
  })

  it('that is hardly more than it may be reads as more', () => {
    const number = (text: string) => Number(text.replaceAll(/\s/g, ''))
    const steps = refusal({
      ...{ scene: 'ramp', duration: 0.123, timeScale: 4.0550398373983745 },
      timestep: { kind: 'substeps', step: 1e-7, maxSteps: 406 },
      frames: { kind: 'recorded', durations: [1e-5] },
    })
    expect(steps).toMatch(/5\s000\s001 steps, more than 5\s000\s000/)
    let refused = 0
    for (let stiffness = 7.4e8; stiffness < 7.8e8; stiffness += 1e6) {
      const [, asked, most] =
        /about ([\d\s]+) evaluations .*, more than ([\d\s]+),/.exec(
          refusal(spring({ stiffness, ...hardly }, fast)),
        ) ?? []
      if (!asked || !most) continue
      refused++
      expect(number(asked), String(stiffness)).toBeGreaterThan(number(most))
    }
    expect(refused).toBeGreaterThan(0)
  })

  it('is bounded for every fast oscillation with located stops', () => {
    // 14 to 60 reversals a frame, each of 8 steps.
    for (const stiffness of [2e9, 1e10, 3.6e10])
      for (const { id: integrator } of integrators)
        expect(refusal(spring({ stiffness, ...hardly }, { integrator, ...fast }))).toMatch(
          /^duration: .* evaluations/,
        )
    // ω = √(g/R) of 31 600/s reverses 10.07 million times.
    const narrow = { radius: 0.001, gravity: 1e6, position: 0.001 }
    expect(refusal(pipe(narrow, fast))).toMatch(/^duration: .* 11\s000\s000 reversals/)
  })

  it('of what friction ends soon is small, however fast it swings', () => {
    // From a drive of 3.6e10 m/s², lessened by 2 μk g each time; and half a right angle over atan μk.
    expect(refusal(spring({ stiffness: 3.6e10, muStatic: 1e6, muKinetic: 1e5 }, fast))).toBe('')
    const narrow = { radius: 0.001, gravity: 1e6, position: 0.001 }
    expect(refusal(pipe({ ...narrow, muKinetic: 0.01 }, fast))).toBe('')
    expect(refusal(spring({ stiffness: 3.6e10, position: 0, ...hardly }, fast))).toBe('')
  })

  it('of turns that nothing locates is none', () => {
    for (const stopping of ['naive', 'clamped'])
      expect(refusal(spring({ stiffness: 3.6e10, ...hardly }, { stopping, ...fast }))).toBe('')
    expect(refusal(spring({ stiffness: 3.6e10, muStatic: 0, muKinetic: 0 }, fast))).toBe('')
  })

  it.each(integrators)('with $id is estimated to within a factor of ten', ({ id, evaluations }) => {
    // A located event takes 3 to 30 trials, as the method and the place in the step have it.
    const { least, most } = evaluations
    for (const perFrame of [0.3, 1, 3])
      for (const fps of [60, 1000]) {
        // ωΔt = π perFrame.
        const omega = Math.PI * perFrame * fps
        const run = simulate(
          spring(
            { stiffness: omega ** 2, ...hardly },
            { integrator: id, frames: { kind: 'steady', fps }, duration: 200 / fps },
          ),
        )
        if (run.outcome.kind === 'diverged') continue
        const estimate = (1 + 8 * perFrame) * run.steps * Math.sqrt(least * most)
        expect(run.evaluations / estimate).toBeGreaterThan(0.1)
        expect(run.evaluations / estimate).toBeLessThan(10)
      }
  })

  it('of frames and a duration has no bound for a run that uses neither', () => {
    const long = {
      ...spring({ stiffness: 3.6e10, ...hardly }, fast),
      timestep: { kind: 'fixed', step: 1e-7 },
    } as const
    expect(refusal(long)).toMatch(/^timestep.step: asks for/)
    expect(parseForRun(long).timestep).toMatchObject({ step: 1e-7 })
    expect(() => parseForRun({ ...long, duration: NaN })).toThrow(ExperimentError)
  })
})
