import type { Book } from './book.ts'
import type { Highlight } from './highlight.ts'
import type { Place } from './problem.ts'

/** What markdown-it hands to every rule: of which book and file a piece of text is. */
export type Env = {
  readonly book: Book
  readonly highlight: Highlight
  readonly file: string
  /** The line of the file on which the piece begins, counted from 0. */
  readonly firstLine: number
}

/** The place of a line of the piece, counted from 0. */
export function placeOf({ file, firstLine }: Env, line: number): Place {
  return { file, line: firstLine + line + 1 }
}
