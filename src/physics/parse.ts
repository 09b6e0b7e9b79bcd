import { defaults, limits } from './experiment.ts'
import type { ResolvedExperiment } from './experiment.ts'
import { frameClocks } from './frames/index.ts'
import { integrators } from './integrators/index.ts'
import { entry } from './lists.ts'
import { measuring } from './measured.ts'
import type { ListOption, NumberOption, Option, Options } from './options.ts'
import { ExperimentError, MOST_SHOWN, nearestName, shorten, show } from './problems.ts'
import type { Problem } from './problems.ts'
import type { Scene } from './scene.ts'
import { scenes } from './scenes/index.ts'
import { stoppings } from './stopping/index.ts'
import { timesteps } from './timesteps/index.ts'
import { workProblems } from './work.ts'

const KEYS = [
  'scene',
  'parameters',
  'integrator',
  'stopping',
  'timestep',
  'frames',
  'duration',
  'timeScale',
]

const measuredClocks = frameClocks.map(({ id, options }) => {
  return { id, options: { ...options, ...measuring } }
})

/** The parameters of all scenes, to check those of an unknown scene against. */
const parametersOfAll: Scene['parameters'] = Object.assign(
  {},
  ...scenes.map(({ parameters }) => parameters),
)

/**
 * The only entry: turns any value (read from an address, an attribute, a message, a file) into an experiment with
 * every default filled in. It reads each property once, into plain data that shares nothing with the value.
 *
 * @throws ExperimentError that names every problem: its path, the given value and what is allowed
 */
export function parseExperiment(value: unknown): ResolvedExperiment {
  const reader = new Reader()
  const experiment = readExperiment(reader, value)
  if (reader.accepts('duration', 'timeScale', 'frames', 'timestep'))
    reader.problems.push(...workProblems(experiment, reader.problems.length === 0))
  return reader.finish(experiment)
}

/**
 * Like `parseExperiment`, for a run that its caller drives: `frames` and `duration` may mean any amount of work,
 * since such a run uses neither.
 */
export function parseForRun(value: unknown): ResolvedExperiment {
  const reader = new Reader()
  return reader.finish(readExperiment(reader, value))
}

function readExperiment(reader: Reader, value: unknown): ResolvedExperiment {
  const given = reader.read('', value, KEYS, `an object with any of ${KEYS.join(', ')}`)
  if (!given) throw new ExperimentError(reader.problems)
  reader.reportUnknown('', given, KEYS)
  if (!('scene' in given)) reader.report('scene', `is missing; it is one of ${ids(scenes)}`)
  const sceneId = 'scene' in given ? reader.id('scene', given.scene, scenes) : undefined
  const scene: Scene | undefined = sceneId === undefined ? undefined : entry(scenes, sceneId)
  const {
    integrator = defaults.integrator,
    stopping = defaults.stopping,
    timestep = defaults.timestep,
    frames = defaults.frames,
    duration = scene?.duration ?? 0,
    timeScale = defaults.timeScale,
  } = given
  const experiment = {
    scene: sceneId!,
    parameters: readParameters(reader, given.parameters, scene),
    integrator: reader.id('integrator', integrator, integrators),
    stopping: reader.id('stopping', stopping, stoppings),
    timestep: reader.choice('timestep', timestep, timesteps),
    frames: reader.choice('frames', frames, measuredClocks),
    duration: reader.number('duration', duration, { min: 0, max: limits.duration }),
    timeScale: reader.number('timeScale', timeScale, limits.timeScale),
  }
  return experiment as ResolvedExperiment
}

function readParameters(reader: Reader, value: unknown = {}, scene: Scene | undefined) {
  const options = scene?.parameters ?? parametersOfAll
  const names = Object.keys(options)
  const path = 'parameters'
  const given = reader.read(path, value, names, `an object with any of ${names.join(', ')}`)
  if (!given) return undefined
  reader.reportUnknown(path, given, names)
  const parameters = reader.options(path, given, options) as Record<string, number>
  const { muStatic, muKinetic } = parameters
  // If only one coefficient is given, the other one's default follows it where needed, so that μs ≥ μk.
  if (muStatic! < muKinetic!) {
    if (!('muStatic' in given)) parameters.muStatic = muKinetic!
    else if (!('muKinetic' in given)) parameters.muKinetic = muStatic!
    else
      reader.report(
        `${path}.muStatic`,
        `${muStatic} is less than muKinetic, ${muKinetic}; static friction is never below kinetic`,
      )
  }
  const conflict = reader.accepts(path) ? scene?.conflict?.(parameters) : undefined
  if (conflict)
    reader.report(
      `${path}.${conflict.parameter}`,
      `${show(parameters[conflict.parameter])} ${conflict.problem}`,
    )
  return parameters
}

function ids(list: readonly { readonly id: string }[]): string {
  return list.map(({ id }) => id).join(', ')
}

/**
 * Lists that this module has made, and the option that each was found valid for. They are frozen: an experiment that was
 * parsed before and is parsed again, as at every move of a slider, has its 100 000 frame times neither checked nor copied.
 */
const accepted = new WeakMap<object, ListOption>()

/** Reads values of every kind, and notes what is wrong instead of stopping at it. */
class Reader {
  readonly problems: Problem[] = []
  /** Paths where a getter or a Proxy threw: the missing value is not reported again. */
  private readonly unread = new Set<string>()

  report(path: string, message: string): void {
    if (!this.unread.has(path)) this.problems.push({ path, message })
  }

  /** Whether these properties of the experiment have no problem so far. */
  accepts(...roots: readonly string[]): boolean {
    return !this.problems.some(({ path }) => roots.includes(path.split('.')[0]!))
  }

  finish(experiment: ResolvedExperiment): ResolvedExperiment {
    if (this.problems.length > 0) throw new ExperimentError(this.problems)
    return experiment
  }

  /** The object's own keys, with the values of the requested ones. */
  read(
    path: string,
    value: unknown,
    names: readonly string[],
    wanted: string,
  ): Record<string, unknown> | undefined {
    const keys = this.attempt(path, () =>
      typeof value === 'object' && value !== null && !Array.isArray(value)
        ? Object.keys(value)
        : undefined,
    )
    if (!keys) {
      this.report(path, `${show(value)} is not ${wanted}`)
      return undefined
    }
    const given = Object.create(null) as Record<string, unknown>
    for (const key of keys)
      given[key] = names.includes(key)
        ? this.attempt(path ? `${path}.${key}` : key, () => (value as typeof given)[key])
        : undefined
    return given
  }

  reportUnknown(path: string, given: object, known: readonly string[]): void {
    for (const key of Object.keys(given)) {
      if (known.includes(key)) continue
      // Guessing a name is slow, and nobody reads a thousand guesses.
      const name = this.problems.length < MOST_SHOWN ? nearestName(key, known) : undefined
      const hint = name ? `did you mean ${name}?` : `known are ${known.join(', ')}`
      this.report(path ? `${path}.${shorten(key)}` : shorten(key), `is not known here; ${hint}`)
    }
  }

  id(path: string, value: unknown, list: readonly { readonly id: string }[]): string | undefined {
    if (list.some(({ id }) => id === value)) return value as string
    const name =
      typeof value === 'string'
        ? nearestName(
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

  options(path: string, given: Record<string, unknown>, options: Options): Record<string, unknown> {
    const result: Record<string, unknown> = {}
    for (const [key, option] of Object.entries(options)) {
      if (key in given && !(option.sparse && given[key] === option.initial))
        result[key] = this.option(`${path}.${key}`, given[key], option)
      else if (option.optional) result[key] = option.initial
      else if (!option.sparse) this.report(`${path}.${key}`, 'is missing')
    }
    return result
  }

  choice(
    path: string,
    value: unknown,
    list: readonly { readonly id: string; readonly options: Options }[],
  ): unknown {
    const names = ['kind', ...list.flatMap(({ options }) => Object.keys(options))]
    const wanted = `an object with a kind, one of ${ids(list)}`
    const given = this.read(path, value, names, wanted)
    if (!given) return undefined
    if (!('kind' in given)) {
      this.report(path, `${show(value)} is not ${wanted}`)
      return undefined
    }
    const kind = this.id(`${path}.kind`, given.kind, list)
    if (kind === undefined) return undefined
    const { options } = entry(list, kind)
    this.reportUnknown(path, given, ['kind', ...Object.keys(options)])
    return { kind, ...this.options(path, given, options) }
  }

  private option(path: string, value: unknown, option: Option): unknown {
    if (option.type === 'number') return this.number(path, value, option)
    if (option.type === 'list') return this.list(path, value, option)
    return this.id(
      path,
      value,
      option.choices.map((id) => ({ id })),
    )
  }

  private list(path: string, value: unknown, option: ListOption): readonly number[] | undefined {
    if (accepted.get(value as object) === option) return value as readonly number[]
    const length = this.attempt(path, () => (Array.isArray(value) ? value.length : undefined))
    if (length === undefined) this.report(path, `${show(value)} is not a list of numbers`)
    else if (!(length >= 1 && length <= option.maxLength))
      this.report(path, `${show(value)} does not hold 1…${option.maxLength} numbers`)
    else {
      const before = this.problems.length
      const list = Array.from({ length }, (_, i) => {
        const at = `${path}[${i}]`
        const item = this.attempt(at, () => (value as unknown[])[i])
        return this.number(at, item, option)
      })
      if (this.problems.length === before) accepted.set(Object.freeze(list), option)
      return list
    }
    return undefined
  }

  /** Reads a property; a getter or a Proxy that throws is reported as a problem. */
  private attempt<T>(path: string, get: () => T): T | undefined {
    try {
      return get()
    } catch (error) {
      this.report(path, `could not be read: ${show(error)}`)
      this.unread.add(path)
      return undefined
    }
  }
}
