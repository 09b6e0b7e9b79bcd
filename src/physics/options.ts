/**
 * How the entries of the lists describe their options. Menus, sliders, `parseExperiment` and the
 * types of an `Experiment` all derive from these descriptions, so a new scene or clock states each once.
 */

/** A number that can be set: its meaning, unit, and the range in which it is valid. */
export interface NumberOption {
  readonly type: 'number'
  readonly label: string
  /** The letter used in formulas. */
  readonly symbol: string
  /** SI unit, empty for a pure number. */
  readonly unit: string
  /** The valid range, both ends included. */
  readonly min: number
  readonly max: number
  /** The meaning of `max` in words, where it is practically no bound. */
  readonly atMax?: string
  /** Only whole numbers are valid. */
  readonly integer?: boolean
  /** The slider's range; typed values may exceed it within `min` and `max`. */
  readonly slider: SliderRange
  /** The value that a control shows first. */
  readonly initial: number
  /** May be left out; the value is then `initial`. */
  readonly optional?: boolean
  /** Is left out where it is `initial`. */
  readonly sparse?: boolean
}

/** The range and step of a slider. */
export interface SliderRange {
  readonly from: number
  readonly to: number
  /** The step of the slider: in the number, or on a logarithmic slider in its decimal logarithm. */
  readonly step: number
  readonly scale?: 'logarithmic'
}

/** One of a few words. */
export interface ChoiceOption {
  readonly type: 'choice'
  readonly label: string
  readonly choices: readonly string[]
  readonly initial: string
  readonly optional?: boolean
  readonly sparse?: boolean
}

/** A list of numbers, each within the range. */
export interface ListOption {
  readonly type: 'list'
  readonly label: string
  readonly unit: string
  readonly min: number
  readonly max: number
  /** The list holds at least one and at most this many numbers. */
  readonly maxLength: number
  readonly initial: readonly number[]
  readonly optional?: boolean
  readonly sparse?: boolean
}

export type Option = NumberOption | ChoiceOption | ListOption
export type Options = Readonly<Record<string, Option>>

/** What every entry of a list has: an id, a label and an explanation. */
export interface Described {
  readonly id: string
  /** The name in menus. */
  readonly label: string
  /** One sentence for a reader who meets it for the first time. */
  readonly about: string
}

type ValueOf<O> = O extends { type: 'number' }
  ? number
  : O extends { type: 'choice'; choices: readonly (infer C)[] }
    ? C
    : readonly number[]

/** A value for every option of a set. */
export type Values<O extends Options> = { -readonly [K in keyof O]: ValueOf<O[K]> }

type OptionalKeys<O extends Options> = {
  [K in keyof O]: O[K] extends { optional: true } ? K : never
}[keyof O]

/** The JSON that chooses an entry of a list: its id as `kind`, and its options, some of them optional. */
export type Chosen<D> = D extends { id: infer Id; options: infer O extends Options }
  ? { kind: Id } & { [K in Exclude<keyof O, OptionalKeys<O>>]: ValueOf<O[K]> } & {
      [K in OptionalKeys<O>]?: ValueOf<O[K]>
    }
  : never

/** Like `Chosen`, with every option given. */
export type ChosenWhole<D> = D extends { id: infer Id; options: infer O extends Options }
  ? { kind: Id } & { [K in keyof O]: ValueOf<O[K]> }
  : never
