import type { Figure } from '../../figures/shared/figure.ts'

/** A figure as the text needs it. */
export interface FigureInfo extends Pick<Figure, 'id' | 'title' | 'controls'> {
  /** The room that it takes, as the text of a style attribute. */
  readonly frame: string
  /** Its picture as it opens, as HTML. */
  readonly still: string
}

/** A file of the text. */
export interface TextFile {
  /** From the project's root. */
  readonly path: string
  readonly text: string
}

/** Everything that the tutorial is made of. */
export interface Materials {
  /** In the order of the page. */
  readonly texts: readonly TextFile[]
  /** The numbers in the prose, by name. */
  readonly facts: Readonly<Record<string, () => string>>
  readonly figures: readonly FigureInfo[]
  /** The files of the take-home step. */
  readonly takeHome: readonly TextFile[]
  /** The text of a file of the project; undefined where there is none. */
  readonly read: (path: string) => string | undefined
  /** The ids that the page has outside the tutorial. */
  readonly pageIds: readonly string[]
}
