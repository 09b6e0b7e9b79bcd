/** A shape that JSON can have: checks a value and says which places in it are wrong. */
export interface Shape<T> {
  /** Adds a line for every wrong place to `problems`; `path` is where the value stands. */
  check(value: unknown, path: string, problems: string[]): void
  /** Never set: carries the type. */
  readonly type?: T
}

/** The type of the values that have a shape. */
export type Shaped<S> = S extends Shape<infer T> ? T : never

function simple<T>(what: string, holds: (value: unknown) => boolean): Shape<T> {
  return {
    check(value, path, problems) {
      if (!holds(value)) problems.push(`${path}: ${shown(value)} is not ${what}`)
    },
  }
}

function shown(value: unknown): string {
  const text: string | undefined = JSON.stringify(value)
  return text === undefined ? 'nothing' : text.length > 60 ? `${text.slice(0, 60)}…` : text
}

export const text = simple<string>('a text', (value) => typeof value === 'string' && value !== '')

export const flag = simple<boolean>('true or false', (value) => typeof value === 'boolean')

export const number = simple<number>('a finite number', (value) => Number.isFinite(value))

/** A finite number, 0 or more. */
export const amount = simple<number>(
  'a number of 0 or more',
  (value) => Number.isFinite(value) && (value as number) >= 0,
)

/** One of a few words. */
export function word<const W extends string>(...words: W[]): Shape<W> {
  return simple(`one of ${words.join(', ')}`, (value) => words.includes(value as W))
}

/** Any number of values of one shape. */
export function list<T>(each: Shape<T>): Shape<T[]> {
  return {
    check(value, path, problems) {
      if (!Array.isArray(value)) problems.push(`${path}: ${shown(value)} is not a list`)
      else value.forEach((entry, index) => each.check(entry, `${path}[${index}]`, problems))
    },
  }
}

/** As the shape says, or null where there is no such value. */
export function orNull<T>(shape: Shape<T>): Shape<T | null> {
  return {
    check(value, path, problems) {
      if (value !== null) shape.check(value, path, problems)
    },
  }
}

/** Values of one shape under any names. */
export function table<T>(each: Shape<T>): Shape<Record<string, T>> {
  return {
    check(value, path, problems) {
      if (!isObject(value)) problems.push(`${path}: ${shown(value)} is not an object`)
      else
        for (const [key, entry] of Object.entries(value))
          each.check(entry, `${path}.${key}`, problems)
    },
  }
}

/** An object with these fields and no others. */
export function recordOf<F extends Record<string, Shape<unknown>>>(
  fields: F,
): Shape<{ [K in keyof F]: Shaped<F[K]> }> {
  return {
    check(value, path, problems) {
      if (!isObject(value)) {
        problems.push(`${path}: ${shown(value)} is not an object`)
        return
      }
      for (const [key, shape] of Object.entries(fields))
        shape.check(value[key], `${path}.${key}`, problems)
      for (const key of Object.keys(value))
        if (!(key in fields)) problems.push(`${path}.${key}: is not known`)
    },
  }
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}
