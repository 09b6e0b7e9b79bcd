import type { Highlight } from './highlight.ts'
import type { FigureInfo, Materials } from './materials.ts'
import { instead } from './problem.ts'
import type { TextPlace, TextProblem } from './problem.ts'

/** An entry of the table of contents. */
export interface Chapter {
  readonly id: string
  readonly title: string
  /** Of a numbered section. */
  readonly number: number | undefined
}

/** What is known of the whole text while its files are turned into HTML one after the other. */
export class Book {
  readonly problems: TextProblem[] = []
  readonly chapters: Chapter[] = []
  private readonly ids = new Map<string, TextPlace | undefined>()
  private readonly links: { readonly id: string; readonly place: TextPlace }[] = []
  private placed = 0
  readonly materials: Materials

  constructor(materials: Materials) {
    this.materials = materials
    for (const id of materials.pageIds) this.ids.set(id, undefined)
  }

  report({ file, line }: TextPlace, message: string): void {
    this.problems.push({ file, line, message })
  }

  /** Gives an id to a place of the page. */
  give(id: string, place: TextPlace): void {
    if (this.ids.has(id)) {
      const other = this.ids.get(id)
      const where = other ? `in ${other.file}:${other.line}` : 'in index.html'
      this.report(place, `the id “${id}” is already given ${where}`)
    } else this.ids.set(id, place)
  }

  /** Remembers a link to a place of the page, to be checked when all are known. */
  link(id: string, place: TextPlace): void {
    this.links.push({ id, place })
  }

  /** Reports every link that leads nowhere. */
  checkLinks(): void {
    for (const { id, place } of this.links)
      if (!this.ids.has(id))
        this.report(place, `the link #${id} leads nowhere${instead(id, this.ids.keys())}`)
  }

  /** The number that the next figure gets. */
  nextFigure(): number {
    return ++this.placed
  }

  /** A figure by name. */
  figure(id: string, place: TextPlace): FigureInfo | undefined {
    const { figures } = this.materials
    const found = figures.find((figure) => figure.id === id)
    if (!found) {
      const names = figures.map((figure) => figure.id)
      this.report(place, `there is no figure “${id}”${instead(id, names)}`)
    }
    return found
  }
}

/** What markdown-it hands to every rule: of which book and file a piece of text is. */
export type Env = {
  readonly book: Book
  readonly highlight: Highlight
  readonly file: string
  /** The line of the file on which the piece begins, counted from 0. */
  readonly firstLine: number
}

/** The place of a line of the piece, counted from 0. */
export function textPlaceOf({ file, firstLine }: Env, line: number): TextPlace {
  return { file, line: firstLine + line + 1 }
}
