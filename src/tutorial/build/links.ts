import { ExperimentError } from '../../physics/index.ts'
import { readAddress } from '../../lab/state/address.ts'
import type { Book } from './book.ts'
import { presetOf, wrongValue } from './presets.ts'
import type { TextPlace } from './problem.ts'

/** What a link becomes on the page. */
interface Link {
  readonly href: string
  readonly attributes: readonly (readonly [name: string, value: string])[]
}

/**
 * A link of the text: to a place of the page (`#id`), to another site (`https:`), one that sets a figure
 * (`set:figure?control=value`), or one that opens an experiment in the lab (`lab:?scene=…`).
 */
export function resolveLink(href: string, book: Book, place: TextPlace): Link {
  if (href.startsWith('#')) {
    book.link(href.slice(1), place)
    return { href, attributes: [] }
  }
  if (href.startsWith('set:')) return presetLink(href.slice(4), book, place)
  if (href.startsWith('lab:')) return labLink(href.slice(4).replace(/^\?/, ''), book, place)
  if (!/^https?:\/\//.test(href))
    book.report(place, `“${href}” is no link: #id, set:figure?…, lab:?… or https://…`)
  return { href, attributes: [] }
}

/** Without JavaScript it leads to the figure. */
function presetLink(address: string, book: Book, place: TextPlace): Link {
  const { figure: id, values } = presetOf(address)
  const figure = book.figure(id, place)
  book.link(`figure-${id}`, place)
  if (values.length === 0)
    book.report(place, `set:${address} sets nothing: set:figure?control=value`)
  if (figure)
    for (const [name, value] of values) {
      const wrong = wrongValue(figure, name, value)
      if (wrong) book.report(place, wrong)
    }
  return { href: `#figure-${id}`, attributes: [['data-set', address]] }
}

function labLink(address: string, book: Book, place: TextPlace): Link {
  try {
    readAddress(address)
  } catch (error) {
    if (!(error instanceof ExperimentError)) throw error
    for (const { path, message } of error.problems)
      book.report(place, `lab:?${address} can’t be opened: ${path}: ${message}`)
  }
  return { href: `#${address}`, attributes: [['data-lab', '']] }
}
