import { readValues } from '../../figures/shared/control.ts'
import type { FigureInfo } from './materials.ts'
import { instead } from './problem.ts'

/** What a `set:` link asks of a figure. */
export interface FigureSetting {
  readonly figure: string
  /** By name of the control, as written. */
  readonly values: readonly (readonly [name: string, value: string])[]
}

/** Reads what follows `set:`: `falling-ball?fps=15&angle=30`. */
export function presetOf(address: string): FigureSetting {
  const [figure = '', query = ''] = address.split('?')
  return { figure, values: [...new URLSearchParams(query)] }
}

/** What is wrong with giving a figure's control a value; undefined where nothing is. */
export function wrongValue(
  { id, controls }: FigureInfo,
  name: string,
  text: string,
): string | undefined {
  const control = Object.hasOwn(controls, name) ? controls[name] : undefined
  if (!control)
    return `the figure “${id}” has no control “${name}”${instead(name, Object.keys(controls))}`
  try {
    const value = readValues(controls, { [name]: text })[name]
    if (control.type !== 'number' || value === Number(text)) return undefined
    return `${name} of the figure “${id}” can’t be ${text}: the nearest that it can is ${String(value)}`
  } catch (error) {
    if (!(error instanceof RangeError)) throw error
    const allowed = control.type === 'choice' ? control.options.map((each) => each.id) : []
    return `${name} of the figure “${id}” can’t be “${text}”${instead(text, allowed)}`
  }
}
