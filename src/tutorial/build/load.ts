import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { facts } from '../facts/index.ts'
import { figureStill, labStill } from '../still/stills.ts'
import { figures } from '../../figures/index.ts'
import type { Figure } from '../../figures/shared/figure.ts'
import { frameOf } from '../../figures/shared/still.ts'
import { highlighter } from './highlight.ts'
import type { FigureInfo, Materials, TextFile } from './materials.ts'
import { TextError } from './problem.ts'
import { tutorialHtml } from './tutorial.ts'

/** The order in which the take-home languages are shown. */
const takeHomeEndings = ['.ts', '.cpp', '.cs', '.gd']

/** Loaded here and not when they are needed: what imports this module may be gone by then. */
const [loaded, highlight] = await Promise.all([
  Promise.all(figures.map(({ load }) => load())),
  highlighter(),
])

export { labStill }

/**
 * The tutorial from the project's files, as HTML.
 *
 * @param pageIds the ids that the page has besides
 * @throws TextError that lists everything in the text that has to be mended
 */
export function tutorialArticle(root: string, pageIds: readonly string[]): string {
  const materials: Materials = {
    texts: filesIn(root, 'src/tutorial/text', ['.md']),
    facts,
    figures: loaded.map(infoOf),
    takeHome: filesIn(root, 'src/tutorial/take-home', takeHomeEndings),
    read: (path) => {
      const file = resolve(root, path)
      return existsSync(file) ? readFileSync(file, 'utf8') : undefined
    },
    pageIds,
  }
  const { html, problems } = tutorialHtml(materials, highlight)
  if (problems.length > 0) throw new TextError(problems)
  return html
}

function infoOf(figure: Figure): FigureInfo {
  const { id, title, controls } = figure
  return { id, title, controls, frame: frameOf(figure), still: figureStill(figure) }
}

/** The files of a folder with certain endings, by ending and then by name. */
function filesIn(root: string, folder: string, endings: readonly string[]): TextFile[] {
  const names = readdirSync(join(root, folder)).sort()
  return endings.flatMap((ending) =>
    names
      .filter((name) => name.endsWith(ending))
      .map((name) => ({
        path: `${folder}/${name}`,
        text: readFileSync(join(root, folder, name), 'utf8'),
      })),
  )
}
