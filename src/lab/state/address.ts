import { ExperimentError, scenes } from '../../physics/index.ts'
import type { Problem, SceneId } from '../../physics/index.ts'
import { withParameters } from '../../measure/index.ts'
import { count, writeNumber } from '../../chart/numbers.ts'
import { readNumber } from '../../chart/typedNumber.ts'
import { checked } from './check.ts'
import { opening, openingOf } from './opening.ts'
import { readRunners, writeRunners } from './runnerText.ts'
import type { LabState } from './state.ts'

/**
 * A lab state as the part of an address after `#`, and back. Only what differs from the opening is written:
 *
 *     scene=half-pipe&radius=3&duration=20&runners=30;60/rk4
 *
 * `scene` is a scene's id, `duration` is in seconds, `timeScale` a number, `runners` is described in runnerText.ts, and
 * every other key is a parameter of the scene. A number is a decimal or a fraction. What is left out is as in the opening
 * of that scene.
 */
export function writeAddress(state: LabState): string {
  const start = openingOf(state.scene)
  const fields: string[] = []
  if (state.scene !== opening.scene) fields.push(`scene=${state.scene}`)
  for (const [name, value] of Object.entries(state.parameters))
    if (value !== start.parameters[name]) fields.push(`${name}=${writeNumber(value)}`)
  if (state.duration !== start.duration) fields.push(`duration=${writeNumber(state.duration)}`)
  if (state.timeScale !== start.timeScale) fields.push(`timeScale=${writeNumber(state.timeScale)}`)
  const runners = writeRunners(state.runners)
  if (runners !== writeRunners(start.runners)) fields.push(`runners=${runners}`)
  return fields.join('&')
}

/** Whether `readAddress` takes an address that is so long. */
export function isReadable(address: string): boolean {
  return address.length <= LONGEST
}

/** Why there is no link to a state; empty where there is one. */
export function whyNoLink(state: LabState): string {
  const { length } = writeAddress(state)
  if (length <= LONGEST) return ''
  return `Too many recorded frames for a link: it would have ${count(length)} characters, and ${count(LONGEST)} can be read again.`
}

/** More than the longest link that a browser or a chat lets through; reading as much takes a moment [characters]. */
const LONGEST = 50_000

/**
 * The state that the part of an address after `#` stands for; an empty one is the opening.
 *
 * @throws ExperimentError that lists every problem
 */
export function readAddress(address: string): LabState {
  const { length } = address
  if (!isReadable(address)) {
    const message = `has ${length} characters, more than the ${LONGEST} that are read`
    throw new ExperimentError([{ path: 'address', message }])
  }
  const problems: Problem[] = []
  const fields = new Map<string, string>()
  // As in the query of any address, but that a plus stands for itself: it separates the items of a list.
  for (const [key, text] of new URLSearchParams(address.replaceAll('+', '%2B'))) {
    if (fields.has(key)) problems.push({ path: key.slice(0, 40), message: 'stands there twice' })
    fields.set(key, text)
  }
  const id = fields.get('scene') ?? opening.scene
  const start = scenes.some((scene) => scene.id === id) ? openingOf(id as SceneId) : opening
  const given = [...fields].filter(
    ([key]) => !['scene', 'duration', 'timeScale', 'runners'].includes(key),
  )
  const values = Object.fromEntries(given.map(([key, text]) => [key, value(text)]))
  const parameters = withParameters(start.parameters, values)
  const number = (key: 'duration' | 'timeScale') =>
    fields.has(key) ? value(fields.get(key)!) : start[key]
  const runners = fields.has('runners')
    ? readRunners(fields.get('runners')!, problems)
    : start.runners
  try {
    const shared = { duration: number('duration'), timeScale: number('timeScale') }
    const state = checked({ scene: id, parameters, ...shared, runners })
    if (problems.length === 0) return state
  } catch (error) {
    if (!(error instanceof ExperimentError)) throw error
    problems.push(...error.problems)
  }
  throw new ExperimentError(problems)
}

/** Whether that part of an address says something about a lab, and is not just the name of a place in the page. */
export function isAddress(address: string): boolean {
  return address === '' || address.includes('=')
}

/** The address of a page of the site that shows a state: `page` is relative to where the site is. */
export function linkTo(page: string, site: string, state: LabState, lesson = ''): string {
  const url = new URL(page, site)
  url.hash = [writeAddress(state), lesson].filter(Boolean).join('&')
  return url.href
}

function value(text: string): unknown {
  return readNumber(text) ?? text
}
