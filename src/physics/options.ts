/**
 * How the things in the lists describe what can be set on them. Menus, sliders, `parseExperiment` and the
 * types of an `Experiment` are all read off these descriptions, so a new scene or clock states each once.
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
  /** What `max` amounts to, in words, where it is as good as no bound. */
  readonly atMax?: string
  /** Only whole numbers are valid. */
  readonly integer?: boolean
  /** What a slider offers; typing may go beyond, up to what is valid. */
  readonly slider: SliderRange
  /** What a control shows when the option first appears. */
  readonly initial: number
  /** May be left out: it is `initial` then. */
  readonly optional?: boolean
}

/** What a slider offers. */
export interface SliderRange {
  readonly from: number
  readonly to: number
  /** From one place of the slider to the next: of the number, or where it is logarithmic of its decimal logarithm. */
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
}

export type Option = NumberOption | ChoiceOption | ListOption
export type Options = Readonly<Record<string, Option>>

/** What every entry of a list says about itself. */
export interface Described {
  readonly id: string
  /** As a menu shows it. */
  readonly label: string
  /** One sentence for a reader who meets it for the first time. */
  readonly about: string
}

type ValueOf<O> = O extends { type: 'number' }
  ? number
  : O extends { type: 'choice'; choices: readonly (infer C)[] }
    ? C
    : readonly number[]

/** The values that a set of options stands for, all of them given. */
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

/** As `Chosen`, with nothing left out. */
export type ChosenWhole<D> = D extends { id: infer Id; options: infer O extends Options }
  ? { kind: Id } & { [K in keyof O]: ValueOf<O[K]> }
  : never
