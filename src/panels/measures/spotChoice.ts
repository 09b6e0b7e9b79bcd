import type { ReactiveControllerHost } from 'lit'
import { nearestSpot, spotRows } from './diagramLayout.ts'
import type { DiagramLayout, DiagramSpot } from './diagramLayout.ts'
import { pointName } from './diagramWords.ts'
import { arrows, pictureChoice } from './pictureArea.ts'
import type { Move, PictureChoice } from './pictureArea.ts'
import type { DiagramPoint } from './points.ts'

/** A diagram in which a spot can be chosen. */
interface Host extends ReactiveControllerHost {
  readonly layout: DiagramLayout | undefined
  words(point: DiagramPoint): string
  show(point: DiagramPoint): void
}

const moves = { ...arrows, Home: [-Infinity, 0], End: [Infinity, 0] } as const

/** The spot of a diagram that is read, by its point's name: it stays chosen where everything is laid out anew. */
export function spotChoice(host: Host): PictureChoice<string> {
  const choice: PictureChoice<string> = pictureChoice(host, {
    label:
      'Speed against error. Left and right go along a curve, up and down to another, Enter shows the run in the lab.',
    moves,
    at: (x, y) => nameOf(host.layout && nearestSpot(host.layout, x, y)),
    next: (from, move) =>
      nameOf(host.layout && nextSpot(host.layout, spotNamed(host.layout, from), move)),
    words: (name) => `${name}: ${host.words(spotNamed(host.layout, name)!.point)}.`,
    show: (name) => {
      const spot = spotNamed(host.layout, name)
      if (!spot) return false
      choice.choose(name)
      host.show(spot.point)
      return true
    },
  })
  return choice
}

/** The spot in a layout whose point has a name, if there is one. */
export function spotNamed(
  layout: DiagramLayout | undefined,
  name: string | undefined,
): DiagramSpot | undefined {
  return (
    layout &&
    spotRows(layout)
      .flat()
      .find((spot) => nameOf(spot) === name)
  )
}

function nameOf(spot: DiagramSpot | undefined): string | undefined {
  return spot && pointName(spot.point)
}

/** Along a curve, or up and down to another: the first spot if none is chosen. */
function nextSpot(
  layout: DiagramLayout,
  from: DiagramSpot | undefined,
  [along, up]: Move,
): DiagramSpot {
  const rows = spotRows(layout)
  const row = from ? rows.findIndex((spots) => spots.includes(from)) : 0
  const spots = rows[(row - up + rows.length) % rows.length]!
  // Another curve is met at the same rate or tolerance.
  const met = spots.findIndex(({ point }) => point.setting === from?.point.setting)
  const place = !from ? 0 : up ? met : spots.indexOf(from) + along
  return spots[Math.max(0, Math.min(spots.length - 1, place))]!
}
