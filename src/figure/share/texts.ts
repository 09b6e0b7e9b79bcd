import type { Experiment } from '../../physics/index.ts'
import { writeAddress } from '../address.ts'
import { experimentOf } from '../check.ts'
import { namesOf } from '../names.ts'
import type { LabState } from '../state.ts'

/** The address of a page of the site that shows a state: `page` is relative to where the site is. */
export function linkTo(page: string, site: string, state: LabState): string {
  const url = new URL(page, site)
  url.hash = writeAddress(state)
  return url.href
}

/** HTML for other people's pages that shows a state in a frame of its own, which can do nothing but run its script. */
export function embedCode(site: string, state: LabState): string {
  const names = namesOf(state.runners).join(', ')
  const attributes = {
    src: linkTo('embed.html', site, state),
    title: `Any Frame Rate: ${state.scene}, ${names}`,
    width: '100%',
    height: '640',
    loading: 'lazy',
    sandbox: 'allow-scripts allow-popups allow-popups-to-escape-sandbox',
    style: 'border: 0',
  }
  const text = Object.entries(attributes).map(([name, value]) => `${name}="${escaped(value)}"`)
  return `<iframe ${text.join(' ')}></iframe>`
}

/** What the runners run, as JSON: a list of experiments, or the experiment if there is but one. */
export function toJson(state: LabState): string {
  const experiments: Experiment[] = state.runners.map((runner) => experimentOf(state, runner))
  return JSON.stringify(experiments.length > 1 ? experiments : experiments[0], null, 2)
}

/** A name for a file of what a lab shows, of letters that every system takes. */
export function fileName(state: LabState, ending: string): string {
  const address = writeAddress(state).replace(/^scene=[^&]*/, '')
  const words = `any-frame-rate ${state.scene} ${address}`.replace(/[^a-z0-9.]+/gi, '-')
  return `${words.slice(0, 80).replace(/[-.]+$/, '')}.${ending}`
}

function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;')
}
