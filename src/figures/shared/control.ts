/** A number on a slider. */
export interface NumberControl {
  readonly type: 'number'
  readonly label: string
  readonly symbol?: string
  readonly unit?: string
  readonly from: number
  readonly to: number
  readonly step: number
  readonly initial: number
  /** It has no slider: the picture sets it. */
  readonly hidden?: true
}

/** The control of a frame rate. */
export function rateControl(initial: number, from = 5, to = 120) {
  return {
    ...{ type: 'number', label: 'Frame rate', unit: 'fps' },
    ...{ from, to, step: 1, initial },
  } as const satisfies NumberControl
}

/** One of a few. */
export interface ChoiceControl {
  readonly type: 'choice'
  readonly label: string
  readonly options: readonly { readonly id: string; readonly label: string }[]
  readonly initial: string
  /** There are more than buttons have room for. */
  readonly menu?: true
  readonly hidden?: true
}

/** On or off. */
export interface SwitchControl {
  readonly type: 'switch'
  readonly label: string
  /** What it means while it is on, and while it is off. */
  readonly about: { readonly on: string; readonly off: string }
  readonly initial: boolean
  readonly hidden?: true
}

/** Frame times [s] that the reader's browser can be asked to record. */
export interface FramesControl {
  readonly type: 'frames'
  readonly label: string
  readonly initial: readonly number[]
  readonly hidden?: true
}

export type Control = NumberControl | ChoiceControl | SwitchControl | FramesControl
export type Controls = Readonly<Record<string, Control>>
export type Value = number | string | boolean | readonly number[]
export type ControlValues = Readonly<Record<string, Value>>

/** The values that controls begin with. */
export function initialValues(controls: Controls): ControlValues {
  return Object.fromEntries(Object.entries(controls).map(([name, { initial }]) => [name, initial]))
}

/**
 * The values after some were given: as they are, or as the text of an address. Numbers are taken to the nearest that the
 * slider has.
 *
 * @throws RangeError for a control that there is not, or a value that it can't have
 */
export function readValues(
  controls: Controls,
  given: Readonly<Record<string, unknown>>,
  before: ControlValues = initialValues(controls),
): ControlValues {
  const read = Object.entries(given).map(([name, value]): [string, Value] => {
    const control = Object.hasOwn(controls, name) ? controls[name] : undefined
    if (!control) {
      const known = Object.keys(controls).join(', ')
      throw new RangeError(`There is no control “${name}” here; there are ${known}.`)
    }
    const result = readValue(control, value)
    if (result === undefined)
      throw new RangeError(`“${String(value)}” is no value of “${control.label}”.`)
    return [name, result]
  })
  return { ...before, ...Object.fromEntries(read) }
}

const switches: Readonly<Record<string, boolean>> = {
  true: true,
  on: true,
  false: false,
  off: false,
}

function readValue(control: Control, value: unknown): Value | undefined {
  if (control.type === 'number') {
    const number = typeof value === 'string' && value.trim() !== '' ? Number(value) : value
    return typeof number === 'number' && Number.isFinite(number)
      ? nearestChoice(control, number)
      : undefined
  }
  if (control.type === 'choice') return control.options.find(({ id }) => id === value)?.id
  if (control.type === 'switch') return typeof value === 'boolean' ? value : switches[String(value)]
  return Array.isArray(value) && value.length > 0 && value.every((each) => each > 0)
    ? (value as number[])
    : undefined
}

/** The number of a slider that is nearest to another, as its shortest decimal. */
export function nearestChoice({ from, to, step }: NumberControl, value: number): number {
  const whole = from + Math.round((value - from) / step) * step
  return Math.min(to, Math.max(from, Number(whole.toPrecision(12)))) + 0
}
