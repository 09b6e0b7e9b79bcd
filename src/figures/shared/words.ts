import { withoutRounding } from '../../measure/index.ts'
import { roughMetres } from '../../chart/numbers.ts'

/** A distance [m] to two digits, on the paths of some metres that the figures have: “0.048 m”, “3.2 mm”. */
export function roughly(distance: number): string {
  return roughMetres(withoutRounding(distance, 1))
}
