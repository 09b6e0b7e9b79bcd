import { cellKinds, coarseCell, withoutRounding } from '../../measure/index.ts'
import type { CellKind, MapRequest, MapRow } from '../../measure/index.ts'
import { decadeAbove, decadeBelow } from '../../chart/magnitudes.ts'

/** Beyond a hundred metres one error is as bad as another: this is the ramp's highest power of ten. */
export const HIGHEST = 2

/** What is known of a cell. */
export interface MapCell {
  readonly kind: CellKind
  /** [m]; 0 where it is rounding, NaN where nothing is measured. */
  readonly value: number
}

/** A map as far as it is computed. */
export class MapCells {
  readonly request: MapRequest
  /** How often something was added: with it, all that is seen of a map changes. */
  version = 0
  private readonly rows: (MapRow | undefined)[]

  constructor(request: MapRequest) {
    this.request = request
    this.rows = Array.from({ length: request.rows })
  }

  take(row: MapRow): void {
    this.rows[row.row] = row
    this.version++
  }

  /** A cell, or as long as it is not computed the one that the first look has in its stead. */
  cell(column: number, row: number): MapCell {
    const own = this.own(column, row)
    if (own.kind !== 'pending') return own
    const { columns, rows } = this.request
    return this.own(coarseCell(column, columns), coarseCell(row, rows))
  }

  /** The powers of ten that the values lie between, those that are rounding left aside. */
  decades(): { low: number; high: number } {
    let low = Infinity
    let high = -Infinity
    for (let row = 0; row < this.rows.length; row++)
      for (let column = 0; column < this.request.columns; column++) {
        const { value } = this.own(column, row)
        if (!(value > 0)) continue
        low = Math.min(low, value)
        high = Math.max(high, value)
      }
    if (low > high) return { low: -3, high: 0 }
    const top = Math.min(HIGHEST, decadeAbove(high))
    return { low: Math.min(top - 1, decadeBelow(low)), high: top }
  }

  /** How many cells there are for which something holds. */
  count(holds: (cell: MapCell) => boolean): number {
    const { columns, rows } = this.request
    let count = 0
    for (let row = 0; row < rows; row++)
      for (let column = 0; column < columns; column++) if (holds(this.own(column, row))) count++
    return count
  }

  private own(column: number, row: number): MapCell {
    const known = this.rows[row]
    if (!known) return { kind: 'pending', value: NaN }
    const kind = cellKinds[known.kinds[column]!]!
    const value = kind === 'measured' ? known.values[column]! : NaN
    return { kind, value: withoutRounding(value, known.scale) }
  }
}
