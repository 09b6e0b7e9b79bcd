import type { ReactiveControllerHost } from 'lit'
import type { MapCells } from './mapCells.ts'
import { cellUnder } from './mapDrawing.ts'
import type { MapFrame, MapPlace } from './mapDrawing.ts'
import { cellWords, placeText } from './mapWords.ts'
import { arrows, pictureChoice } from './pictureChoice.ts'
import type { PictureChoice } from './pictureChoice.ts'

/** A map in which a cell can be chosen. */
interface Host extends ReactiveControllerHost {
  readonly cells: MapCells
  readonly frame: MapFrame
  show(place: MapPlace): void
}

/** Where the cross hair of a map is. */
export function mapCross(host: Host): PictureChoice<MapPlace> {
  return pictureChoice(host, {
    label:
      'Frame-rate map. The arrow keys move the cross hair, with Shift by ten, Enter shows the run in the lab.',
    moves: arrows,
    at: (x, y) => cellUnder(host.cells.request, host.frame, x, y),
    next: (from, [across, up], shift) => {
      const { columns, rows } = host.cells.request
      const { column, row } = from ?? { column: columns / 2, row: rows / 2 }
      const steps = shift ? 10 : 1
      return {
        column: Math.max(0, Math.min(columns - 1, column + across * steps)),
        row: Math.max(0, Math.min(rows - 1, row + up * steps)),
      }
    },
    words: ({ column, row }) => {
      const { request } = host.cells
      return `${placeText(request, column, row)}: the run ${cellWords(host.cells.cell(column, row), request)}.`
    },
    show: (place) => {
      if (place) host.show(place)
      return true
    },
  })
}
