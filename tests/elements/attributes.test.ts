import { describe, expect, it } from 'vitest'
import { stateAsked } from '../../src/elements/attributes.ts'
import { opening, openingOf } from '../../src/lab/state/opening.ts'
import { toJson } from '../../src/panels/share/texts.ts'
import {
  ExperimentError,
  integrators,
  scenes,
  stoppings,
  timesteps,
} from '../../src/physics/index.ts'

/** The problems with what was asked, a line each. */
function problems(asked: Parameters<typeof stateAsked>[0]): string[] {
  try {
    stateAsked(asked)
  } catch (error) {
    if (error instanceof ExperimentError)
      return error.problems.map(({ path, message }) => `${path}: ${message}`)
    throw error
  }
  return []
}

describe('attributes', () => {
  it('ask for the opening of a scene where they say nothing else', () => {
    expect(stateAsked({})).toEqual(opening)
    expect(stateAsked({ scene: null, fps: '', experiment: undefined })).toEqual(opening)
    for (const { id } of scenes) expect(stateAsked({ scene: id })).toEqual(openingOf(id))
  })

  it('take every integrator, stopping rule and timestep policy by its name', () => {
    for (const { id: integrator } of integrators)
      for (const { id: stopping } of stoppings)
        for (const { id: timestep } of timesteps) {
          const { runners } = stateAsked({ integrator, stopping, timestep })
          expect(runners).toHaveLength(3)
          for (const runner of runners) {
            expect(runner).toMatchObject({ integrator, stopping })
            expect(runner.timestep.kind).toBe(timestep)
          }
        }
  })

  it('give a block for each frame rate, as text, number or list', () => {
    const rates = (fps: unknown) =>
      stateAsked({ fps }).runners.map(({ frames }) => 'fps' in frames && frames.fps)
    expect(rates('5, 3/2;60  144')).toEqual([5, 1.5, 60, 144])
    expect(rates(24)).toEqual([24])
    expect(rates([24, '30'])).toEqual([24, 30])
    expect(
      stateAsked({ fps: '1 2 3 4 5 6 7 8' }).runners.map(({ paletteIndex }) => paletteIndex),
    ).toEqual([0, 1, 2, 3, 4, 5, 6, 7])
  })

  it('take an experiment, and change what else they name in it', () => {
    const experiment = { scene: 'half-pipe', parameters: { radius: 3 }, integrator: 'rk4' }
    const state = stateAsked({ experiment: JSON.stringify(experiment) })
    expect(stateAsked({ experiment })).toEqual(state)
    expect(state).toMatchObject({ scene: 'half-pipe', runners: [{ integrator: 'rk4' }] })
    expect(state.parameters.radius).toBe(3)
    const other = stateAsked({ experiment, integrator: 'midpoint', duration: '2.5', fps: '10 20' })
    expect(other.parameters).toEqual(state.parameters)
    expect(other).toMatchObject({ duration: 2.5, runners: [{ integrator: 'midpoint' }, {}] })
  })

  it('take what “Copy as JSON” gives', () => {
    for (const { id } of scenes)
      expect(stateAsked({ experiment: toJson(openingOf(id)) })).toEqual(openingOf(id))
  })

  it('take a timestep with its options', () => {
    const timestep = { kind: 'substeps', step: 0.01, maxSteps: 7 }
    for (const given of [timestep, JSON.stringify(timestep)])
      expect(stateAsked({ timestep: given }).runners[0]!.timestep).toEqual(timestep)
  })

  it('are told of by name, each once, where they ask for what can’t be run', () => {
    expect(problems({ scene: 'rampp', integrator: 'rk5', duration: 'long' })).toEqual([
      expect.stringMatching(/^scene: "rampp" is not one of .*did you mean ramp\?$/),
      expect.stringMatching(/^integrator: "rk5" is not one of .*did you mean rk4\?$/),
      'duration: "long" is not a number',
    ])
    expect(problems({ fps: '10 0' })).toEqual(['fps: 0 is not in 1…10000'])
    expect(problems({ timestep: 'fixd' })).toEqual([expect.stringMatching(/^timestep: "fixd" is/)])
    expect(problems({ experiment: '{' })).toEqual([
      expect.stringMatching(/^experiment: is not JSON/),
    ])
    expect(problems({ experiment: '[]' })).toEqual([
      expect.stringMatching(/^experiment: asks for 0/),
    ])
    expect(problems({ experiment: '7' })).toEqual([expect.stringMatching(/^experiment: 7 is not/)])
    expect(problems({ fps: '1 2 3 4 5 6 7 8 9' })).toEqual([
      expect.stringMatching(/^fps: asks for 9/),
    ])
    expect(problems({ experiment: { scene: 'ramp', parameters: { angel: 1 } } })).toEqual([
      'experiment.parameters.angel: is not known here; did you mean angle?',
    ])
    expect(
      problems({ experiment: [{ scene: 'ramp' }, { scene: 'ramp', stopping: 'no' }] }),
    ).toEqual([expect.stringMatching(/^experiment\[1\]\.stopping: "no" is not one of/)])
    expect(problems({ experiment: [{ scene: 'ramp' }, { scene: 'fall' }] })).toEqual([
      expect.stringMatching(/^experiment\[1\]: is not like the first/),
    ])
  })
})
