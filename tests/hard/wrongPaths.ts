import {
  frameClocks,
  integrators,
  limits,
  measuring,
  scenes,
  stoppings,
  timesteps,
} from '../../src/physics/index.ts'
import type { Option, Options, Scene } from '../../src/physics/index.ts'

type Json = Record<string, unknown>

const KEYS = [
  ...['scene', 'parameters', 'integrator', 'stopping', 'timestep', 'frames'],
  ...['duration', 'timeScale'],
]
const parametersOfAll: Options = Object.assign({}, ...scenes.map(({ parameters }) => parameters))

/** What only goes wrong together: parameters that conflict, and a run that is too long. */
export const TOGETHER = ['parameters.position', 'parameters.muStatic', 'duration', 'timestep.step']

/**
 * The paths at which a value is wrong, by the descriptions of the lists alone: what `parseExperiment` has to name, no
 * more and no less. What only goes wrong together is not among them.
 */
export function wrongPaths(value: unknown): string[] {
  const wrong: string[] = []
  if (!isObject(value)) return ['']
  unknownKeys('', value, KEYS, wrong)
  const get = (key: string, usual?: unknown): unknown =>
    Object.hasOwn(value, key) && value[key] !== undefined ? value[key] : usual
  const scene = (scenes as readonly Scene[]).find(({ id }) => id === get('scene'))
  if (!scene) wrong.push('scene')
  const parameters = get('parameters', {})
  // Under an unknown scene a parameter is right that is right in some scene.
  const known = scene?.parameters ?? parametersOfAll
  if (isObject(parameters)) {
    unknownKeys('parameters.', parameters, Object.keys(known), wrong)
    wrongOptions('parameters.', parameters, known, wrong)
  } else wrong.push('parameters')
  for (const [key, list] of [
    ['integrator', integrators],
    ['stopping', stoppings],
  ] as const) {
    const given = get(key, list[0].id)
    if (!list.some(({ id }) => id === given)) wrong.push(key)
  }
  for (const [key, list, usual] of [
    ['timestep', timesteps, { kind: 'variable' }],
    ['frames', frameClocks, { kind: 'steady', fps: 60 }],
  ] as const) {
    const given = get(key, usual)
    if (!isObject(given) || !Object.hasOwn(given, 'kind')) {
      wrong.push(key)
      continue
    }
    const chosen = list.find(({ id }) => id === given.kind)
    if (!chosen) {
      wrong.push(`${key}.kind`)
      continue
    }
    const options = { ...chosen.options, ...(key === 'frames' && measuring) }
    unknownKeys(`${key}.`, given, ['kind', ...Object.keys(options)], wrong)
    wrongOptions(`${key}.`, given, options, wrong)
  }
  const duration = get('duration', 0)
  if (!(typeof duration === 'number' && duration >= 0 && duration <= limits.duration))
    wrong.push('duration')
  const timeScale = get('timeScale', 1)
  const { min, max } = limits.timeScale
  if (!(typeof timeScale === 'number' && timeScale >= min && timeScale <= max))
    wrong.push('timeScale')
  return wrong
}

const isObject = (value: unknown): value is Json =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

function unknownKeys(path: string, value: Json, known: readonly string[], wrong: string[]): void {
  for (const key of Object.keys(value))
    if (!known.includes(key)) {
      const characters = Array.from(key)
      wrong.push(path + (characters.length > 40 ? `${characters.slice(0, 40).join('')}…` : key))
    }
}

function wrongOptions(path: string, value: Json, options: Options, wrong: string[]): void {
  for (const [key, option] of Object.entries(options)) {
    if (!Object.hasOwn(value, key)) {
      if (!option.optional && !option.sparse) wrong.push(path + key)
    } else wrongValue(path + key, value[key], option, wrong)
  }
}

function wrongValue(path: string, value: unknown, option: Option, wrong: string[]): void {
  const inRange = (x: unknown, whole = false): boolean =>
    option.type !== 'choice' &&
    typeof x === 'number' &&
    x >= option.min &&
    x <= option.max &&
    (!whole || Number.isInteger(x))
  if (option.type === 'choice') {
    if (!(typeof value === 'string' && option.choices.includes(value))) wrong.push(path)
  } else if (option.type === 'number') {
    if (!inRange(value, option.integer)) wrong.push(path)
  } else if (!Array.isArray(value) || value.length < 1 || value.length > option.maxLength)
    wrong.push(path)
  else for (let i = 0; i < value.length; i++) if (!inRange(value[i])) wrong.push(`${path}[${i}]`)
}
