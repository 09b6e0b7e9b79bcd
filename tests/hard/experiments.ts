/**
 * Random experiments, drawn from what the lists say about their options: an entry that is added to a list is drawn
 * from then on.
 */
import fc from 'fast-check'
import type { Arbitrary } from 'fast-check'
import {
  frameClocks,
  integrators,
  limits,
  measuring,
  parseExperiment,
  scenes,
  stoppings,
  timesteps,
} from '../../src/physics/index.ts'
import type {
  NumberOption,
  Option,
  Options,
  ResolvedExperiment,
  Scene,
} from '../../src/physics/index.ts'
import type { FrameClock } from '../../src/physics/frameClock.ts'
import type { TimestepPolicy } from '../../src/physics/timestepPolicy.ts'
import { workProblems } from '../../src/physics/work.ts'

/** How an option's values are drawn: `tame` within its slider, `wild` anywhere in its valid range. */
type Draw = (option: NumberOption) => Arbitrary<number>

const EVEN = 1_000_000

/** Evenly spread over what a slider offers. */
export const tame: Draw = ({ integer, slider: { from, to } }) =>
  integer
    ? fc.integer({ min: from, max: to })
    : fc.integer({ min: 0, max: EVEN }).map((part) => from + ((to - from) * part) / EVEN)

// The ends of the floating-point numbers' own ranges, and sizes at which rounding bites.
const CORNERS = [0, 5e-324, 1e-310, 2.3e-308, 1e-200, 1e-154, 1e-16, 1e-9, 1, 1e9]

/** Of every size that is valid, denormals and both ends of the range among them, half of them tame. */
const wild: Draw = (option) => {
  const { min, max, integer, initial } = option
  if (integer) return fc.oneof(tame(option), fc.integer({ min, max }), fc.constantFrom(min, max))
  const corners = [...CORNERS, ...CORNERS.map((x) => -x)].filter((x) => x >= min && x <= max)
  return fc.oneof(
    { weight: 4, arbitrary: tame(option) },
    { weight: 1, arbitrary: fc.constant(initial) },
    { weight: 1, arbitrary: fc.constantFrom(min, max, ...corners) },
    // Even over the bit patterns, and so over the orders of magnitude.
    { weight: 2, arbitrary: fc.double({ min, max, noNaN: true }) },
  )
}

function value(option: Option, draw: Draw): Arbitrary<unknown> {
  if (option.type === 'number') return draw(option)
  if (option.type === 'choice') return fc.constantFrom(...option.choices)
  const { min, max, initial } = option
  // A list has no slider: its numbers are drawn around the first that it begins with.
  const item = {
    type: 'number',
    label: '',
    symbol: '',
    unit: '',
    min,
    max,
    slider: { from: Math.max(min, initial[0]! / 10), to: Math.min(max, initial[0]! * 10), step: 1 },
    initial: initial[0]!,
  } as const
  return fc.array(draw(item), { minLength: 1, maxLength: 6 })
}

/** A value for every option. */
function values(options: Options, draw: Draw): Arbitrary<Record<string, unknown>> {
  return fc.record(
    Object.fromEntries(Object.entries(options).map(([key, option]) => [key, value(option, draw)])),
  )
}

type Entry = { readonly id: string; readonly options: Options }

/** An entry of a list as an experiment names it. */
export function choice(list: readonly Entry[], draw: Draw): Arbitrary<{ kind: string }> {
  return fc.oneof(
    ...list.map(({ id, options }) => values(options, draw).map((all) => ({ kind: id, ...all }))),
  )
}

/** A scene's parameters, all of them, that go together. */
function parametersOf(scene: Scene, draw: Draw): Arbitrary<Record<string, number>> {
  return values(scene.parameters, draw).map((drawn) => {
    const parameters = drawn as Record<string, number>
    // Static friction below kinetic is refused.
    if ('muStatic' in parameters)
      parameters.muStatic = Math.max(parameters.muStatic!, parameters.muKinetic!)
    for (;;) {
      const conflict = scene.conflict?.(parameters)
      if (!conflict) return parameters
      parameters[conflict.parameter]! /= 2
    }
  })
}

const id = <T extends { readonly id: string }>(list: readonly T[]): Arbitrary<T['id']> =>
  fc.constantFrom(...list.map((each) => each.id))

/** What to draw from; all of each list unless given. */
interface Lists {
  scenes?: readonly Scene[]
  integrators?: readonly { readonly id: string }[]
  stoppings?: readonly { readonly id: string }[]
  timesteps?: readonly Entry[]
  frameClocks?: readonly Entry[]
}

/**
 * A valid experiment with nothing left out, its duration cut to what some hundred frames and a thousand steps can do,
 * so that a million of them can be run.
 */
export function experiments(how: 'tame' | 'wild', from: Lists = {}): Arbitrary<ResolvedExperiment> {
  const draw = how === 'tame' ? tame : wild
  const duration =
    how === 'tame'
      ? fc.integer({ min: 0, max: 4000 }).map((ms) => ms / 1000)
      : fc.oneof(
          fc.integer({ min: 0, max: 4000 }).map((ms) => ms / 1000),
          fc.double({ min: 0, max: 1e6, noNaN: true }),
        )
  // Half of the wild ones are measured wrongly, and half are slow or fast.
  const measured =
    how === 'tame' ? fc.constant({}) : fc.oneof(fc.constant({}), values(measuring, draw))
  const timeScale =
    how === 'tame'
      ? fc.constant(1)
      : fc.oneof(fc.constant(1), fc.double({ ...limits.timeScale, noNaN: true }))
  return fc
    .constantFrom(...(from.scenes ?? scenes))
    .chain((scene) =>
      fc.record({
        scene: fc.constant(scene.id),
        parameters: parametersOf(scene, draw),
        integrator: id(from.integrators ?? integrators),
        stopping: id(from.stoppings ?? stoppings),
        timestep: choice(from.timesteps ?? timesteps, draw),
        frames: fc
          .tuple(choice(from.frameClocks ?? frameClocks, draw), measured)
          .map(([frames, measured]) => ({ ...frames, ...measured })),
        duration,
        timeScale,
      }),
    )
    .map((experiment) => {
      const cut = affordable(experiment as ResolvedExperiment)
      // An oscillation of which nobody can locate every reversal is stepped with another rule.
      const tooMuch = workProblems(cut, true).length > 0
      return parseExperiment(tooMuch ? { ...cut, stopping: 'clamped' } : cut)
    })
}

const MOST_FRAMES = 400
const MOST_STEPS = 1000

/** Frames and steps that an experiment asks for, by what its clock and its policy say of themselves. */
export function work({ frames, timestep, duration, timeScale }: ResolvedExperiment) {
  const clock: FrameClock = frameClocks.find((each) => each.id === frames.kind)!
  const policy: TimestepPolicy = timesteps.find((each) => each.id === timestep.kind)!
  const count = Math.ceil(clock.frames(frames as never, duration))
  // Of a frame that is snapped to a display, a refresh counts at the least.
  const snapped = frames.delta === 'snapped' ? count / (frames.snapTo ?? 60) : 0
  const gameTime = timeScale * (duration + snapped)
  return {
    frames: count,
    steps: policy.steps(timestep as never, gameTime, count),
  }
}

function affordable(experiment: ResolvedExperiment): ResolvedExperiment {
  const { frames, steps } = work(experiment)
  const excess = Math.max(1, frames / MOST_FRAMES, steps / MOST_STEPS)
  let { duration } = experiment
  duration /= excess
  // A clock's count of frames may begin high, and steps with it, which only a shorter run's own length bounds, if at all.
  while (duration > 1e-9 && work({ ...experiment, duration }).steps > 100 * MOST_STEPS)
    duration /= 2
  const cut = { ...experiment, duration }
  // A frame that is snapped to a display lasts a refresh, however short the run is.
  const isTooMuch = experiment.frames.delta === 'snapped' && work(cut).steps > 100 * MOST_STEPS
  return isTooMuch ? { ...cut, frames: { ...cut.frames, delta: 'rounded' } } : cut
}
