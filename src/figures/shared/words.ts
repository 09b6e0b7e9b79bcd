import { metres } from '../../chart/numbers.ts'

/** A distance [m] to two digits: “0.048 m”, “3.2 mm”. */
export function roughly(distance: number): string {
  return metres(Number(distance.toPrecision(2)))
}
