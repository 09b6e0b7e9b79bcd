import { defaults, limits } from './experiment.ts'
import type { ResolvedExperiment } from './experiment.ts'
import type { FrameClock } from './frameClock.ts'
import { frameClocks } from './frames/index.ts'
import { integrators } from './integrators/index.ts'
import { entry } from './lists.ts'
import type { NumberOption, Option, Options } from './options.ts'
import { ExperimentError, MOST_SHOWN, nearest, shorten, show } from './problems.ts'
import type { Problem } from './problems.ts'
import type { Scene } from './scene.ts'
import { scenes } from './scenes/index.ts'
import { stoppings } from './stopping/index.ts'
import type { TimestepPolicy } from './timestepPolicy.ts'
import { timesteps } from './timesteps/index.ts'

const KEYS = ['scene', 'parameters', 'integrator', 'stopping', 'timestep', 'frames', 'duration']

/**
 * The only way in: turns any value (read from an address, an attribute, a message, a file) into an experiment with
 * nothing left out.
 *
 * @throws ExperimentError that names every problem: the path, what was given and what is allowed
 */
export function parseExperiment(value: unknown): ResolvedExperiment {
  const reader = new Reader()
  const given = reader.object('', value, KEYS)
  if (!given) throw new ExperimentError(reader.problems)
  if (!Object.hasOwn(given, 'scene'))
    reader.report('scene', `is missing; it is one of ${ids(scenes)}`)
  const sceneId = Object.hasOwn(given, 'scene')
    ? reader.id('scene', given.scene, scenes)
    : undefined
  const scene: Scene | undefined = sceneId === undefined ? undefined : entry(scenes, sceneId)
  const {
    parameters = {},
    integrator = defaults.integrator,
    stopping = defaults.stopping,
    timestep = defaults.timestep,
    frames = defaults.frames,
    duration = scene?.duration ?? 0,
  } = given
  const experiment = {
    scene: sceneId!,
    parameters: scene ? reader.options('parameters', parameters, scene.parameters) : {},
    integrator: reader.id('integrator', integrator, integrators),
    stopping: reader.id('stopping', stopping, stoppings),
    timestep: reader.choice('timestep', timestep, timesteps),
    frames: reader.choice('frames', frames, frameClocks),
    duration: reader.number('duration', duration, { min: 0, max: limits.duration }),
  } as ResolvedExperiment
  if (reader.problems.length === 0) {
    const conflict = scene!.conflict?.(experiment.parameters)
    if (conflict)
      reader.report(
        `parameters.${conflict.parameter}`,
        `${show(experiment.parameters[conflict.parameter])} ${conflict.problem}`,
      )
    boundWork(experiment, reader)
  }
  if (reader.problems.length > 0) throw new ExperimentError(reader.problems)
  return experiment
}

/** Refuses a run that would take too long, before it starts. */
function boundWork({ duration, frames, timestep }: ResolvedExperiment, reader: Reader): void {
  const clock: FrameClock = entry(frameClocks, frames.kind)
  const policy: TimestepPolicy = entry(timesteps, timestep.kind)
  const frameCount = clock.frames(frames as never, duration)
  const stepCount = policy.steps(timestep as never, duration, frameCount)
  if (frameCount > limits.frames)
    reader.report(
      'duration',
      `${duration} s asks for ${count(frameCount)} frames, more than ${count(limits.frames)}; shorten it or lower the frame rate`,
    )
  if (stepCount > limits.steps)
    reader.report(
      'timestep.step',
      `asks for ${count(stepCount)} steps, more than ${count(limits.steps)}; lengthen the step or shorten the duration`,
    )
}

function count(x: number): string {
  return Math.round(x)
    .toString()
    .replace(/\B(?=(\d{3})+$)/g, '\u202f')
}

function ids(list: readonly { readonly id: string }[]): string {
  return list.map(({ id }) => id).join(', ')
}

/** Reads values of every kind, and notes what is wrong instead of stopping at it. */
class Reader {
  readonly problems: Problem[] = []

  report(path: string, message: string): void {
    this.problems.push({ path, message })
  }

  object(
    path: string,
    value: unknown,
    known: readonly string[],
  ): Record<string, unknown> | undefined {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) {
      this.report(path, `${show(value)} is not an object with any of ${known.join(', ')}`)
      return undefined
    }
    for (const key of Object.keys(value)) {
      if (known.includes(key)) continue
      // A guess takes a while, and nobody reads a thousand.
      const name = this.problems.length < MOST_SHOWN ? nearest(key, known) : undefined
      const hint = name ? `did you mean ${name}?` : `known are ${known.join(', ')}`
      this.report(path ? `${path}.${shorten(key)}` : shorten(key), `is not known here; ${hint}`)
    }
    // Inherited properties are nobody's wish: only the object's own count.
    return Object.fromEntries(
      known
        .filter((key) => Object.hasOwn(value, key))
        .map((key) => [key, (value as Record<string, unknown>)[key]]),
    )
  }

  id(path: string, value: unknown, list: readonly { readonly id: string }[]): string | undefined {
    if (list.some(({ id }) => id === value)) return value as string
    const name =
      typeof value === 'string'
        ? nearest(
            value,
            list.map(({ id }) => id),
          )
        : undefined
    this.report(
      path,
      `${show(value)} is not one of ${ids(list)}${name ? `; did you mean ${name}?` : ''}`,
    )
    return undefined
  }

  number(
    path: string,
    value: unknown,
    range: Pick<NumberOption, 'min' | 'max' | 'integer'>,
  ): number {
    const { min, max, integer = false } = range
    if (typeof value !== 'number') this.report(path, `${show(value)} is not a number`)
    else if (!(value >= min && value <= max))
      this.report(path, `${show(value)} is not in ${min}…${max}`)
    else if (integer && !Number.isInteger(value))
      this.report(path, `${show(value)} is not a whole number in ${min}…${max}`)
    // + 0 turns −0, which JSON can't say, into 0.
    else return value + 0
    return NaN
  }

  option(path: string, value: unknown, option: Option): unknown {
    if (option.type === 'number') return this.number(path, value, option)
    if (option.type === 'choice') {
      return this.id(
        path,
        value,
        option.choices.map((id) => ({ id })),
      )
    }
    if (!Array.isArray(value)) this.report(path, `${show(value)} is not a list of numbers`)
    else if (value.length < 1 || value.length > option.maxLength)
      this.report(path, `${show(value)} does not hold 1…${option.maxLength} numbers`)
    // Array.from sees the holes of a list, which `map` skips.
    else return Array.from(value, (item, i) => this.number(`${path}[${i}]`, item, option))
    return undefined
  }

  options(
    path: string,
    value: unknown,
    options: Options,
    also: readonly string[] = [],
  ): Record<string, unknown> {
    const given = this.object(path, value, [...also, ...Object.keys(options)])
    const result: Record<string, unknown> = {}
    for (const [key, option] of Object.entries(options)) {
      if (!given) continue
      if (Object.hasOwn(given, key)) result[key] = this.option(`${path}.${key}`, given[key], option)
      else if (option.optional) result[key] = option.initial
      else this.report(`${path}.${key}`, 'is missing')
    }
    return result
  }

  choice(
    path: string,
    value: unknown,
    list: readonly { readonly id: string; readonly options: Options }[],
  ): unknown {
    // What else may be wrong with it, `options` says.
    if (value === null || !Object.hasOwn(value as object, 'kind')) {
      this.report(path, `${show(value)} is not an object with a kind, one of ${ids(list)}`)
      return undefined
    }
    const kind = this.id(`${path}.kind`, (value as { kind: unknown }).kind, list)
    if (kind === undefined) return undefined
    return { kind, ...this.options(path, value, entry(list, kind).options, ['kind']) }
  }
}
