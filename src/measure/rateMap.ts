import { ExperimentError, parseExperiment, simulate } from '../physics/index.ts'
import type { Experiment, Trajectory } from '../physics/index.ts'
import { presentationErrorSizes } from './error.ts'
import { scaleOf } from './rounding.ts'
import { spreadOf } from './spread.ts'
import { withParameters } from './withParameters.ts'

/** A map over frame rates, from left to right, and the values of a parameter, from bottom to top. */
export interface MapRequest {
  /** The map replaces its frames and the mapped parameter. */
  readonly experiment: Experiment
  /** The largest error of a run, or how far it ends from the run at `REFERENCE_RATE`. */
  readonly of: 'error' | 'spread'
  readonly parameter: string
  readonly from: number
  readonly to: number
  /** Frames a second at the left edge and at the right; the axis is logarithmic. */
  readonly slowest: number
  readonly fastest: number
  readonly columns: number
  readonly rows: number
}

/** Some cells of one row of a map. */
export interface MapRow {
  readonly row: number
  /** [m], for the cells that are `measured`. */
  readonly values: Float64Array
  /** What each cell is, as a place in `cellKinds`. */
  readonly kinds: Uint8Array
  /** The length of the row's path, against which rounding is measured [m]. */
  readonly scale: number
}

/** The state of a cell: pending, measured, or without a value for one of these reasons. */
export const cellKinds = [
  'pending',
  'measured',
  'left-the-track',
  'diverged',
  // It ends on the track, and its reference run does not.
  'different',
  'refused',
  'unknown',
] as const
export type CellKind = (typeof cellKinds)[number]

/** The rate that spreads are measured against: most players' frame rate [fps]. */
export const REFERENCE_RATE = 60

/** The first, coarse pass over a map computes one row and one column in this many. */
export const COARSE = 8

/** The frame rate at the middle of a column, to three digits, as a reader would type it [fps]. */
export function rateAt({ slowest, fastest, columns }: MapRequest, column: number): number {
  return short(slowest * (fastest / slowest) ** ((column + 0.5) / columns), 3)
}

/** The parameter's value at the middle of a row, to four digits. */
export function rowValue({ from, to, rows }: MapRequest, row: number): number {
  return short(from + ((to - from) * (row + 0.5)) / rows, 4)
}

/** The run behind a cell. */
export function mappedExperiment(request: MapRequest, column: number, row: number): Experiment {
  return cellExperiment(request, rateAt(request, column), row)
}

/** The row or column that stands for its neighbours in the coarse pass. */
export function coarseCell(index: number, count: number): number {
  return Math.min(count - 1, index - (index % COARSE) + COARSE / 2)
}

/**
 * Computes a map, a row at a time: first a coarse pass over every eighth cell both ways, then all of it. A row of the second
 * pass has all of its cells.
 */
export function* rateMap(request: MapRequest): Generator<MapRow> {
  const { rows, columns } = request
  for (const row of coarseCells(rows)) yield mapRow(request, row, coarseCells(columns))
  const all = Array.from({ length: columns }, (_, column) => column)
  for (let row = 0; row < rows; row++) yield mapRow(request, row, all)
}

/** How many rows `rateMap` yields. */
export function rowsOf({ rows }: MapRequest): number {
  return coarseCells(rows).length + rows
}

function coarseCells(count: number): number[] {
  return Array.from({ length: Math.ceil(count / COARSE) }, (_, i) => coarseCell(i * COARSE, count))
}

function mapRow(request: MapRequest, row: number, columns: readonly number[]): MapRow {
  const values = new Float64Array(request.columns).fill(NaN)
  const kinds = new Uint8Array(request.columns)
  let scale = 1
  try {
    const reference = cellExperiment(request, REFERENCE_RATE, row)
    scale = scaleOf(parseExperiment(reference)).length
    const measure = request.of === 'error' ? errorOf : apartFrom(simulate(reference))
    for (const column of columns) {
      const { kind, value } = measure(simulate(mappedExperiment(request, column, row)))
      values[column] = value
      kinds[column] = cellKinds.indexOf(kind)
    }
  } catch (error) {
    if (!(error instanceof ExperimentError)) throw error
    // What can't be run at one frame rate is due to the parameter, and so holds for the whole row.
    kinds.fill(cellKinds.indexOf('refused'))
  }
  return { row, values, kinds, scale }
}

interface Measured {
  readonly kind: CellKind
  readonly value: number
}

function errorOf(run: Trajectory): Measured {
  return measured(run, presentationErrorSizes(run).largest)
}

function apartFrom(reference: Trajectory): (run: Trajectory) => Measured {
  return (run) => {
    const { agree, distance } = spreadOf([reference, run])
    const cell = measured(run, distance)
    return cell.kind === 'measured' && !agree ? { kind: 'different', value: NaN } : cell
  }
}

function measured({ outcome: { kind } }: Trajectory, value: number): Measured {
  if (kind === 'left-the-track' || kind === 'diverged') return { kind, value: NaN }
  return { kind: Number.isFinite(value) ? 'measured' : 'unknown', value }
}

function cellExperiment(request: MapRequest, fps: number, row: number): Experiment {
  const { experiment, parameter } = request
  return {
    ...experiment,
    parameters: withParameters(
      { ...experiment.parameters },
      { [parameter]: rowValue(request, row) },
    ),
    frames: { kind: 'steady', fps },
  }
}

function short(value: number, digits: number): number {
  return Number(value.toPrecision(digits))
}
