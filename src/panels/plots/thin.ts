/**
 * The rows of a curve that can be told apart on a screen: of each column of pixels the lowest and the highest, so that
 * no extreme is lost, and the first and the last row. Rows without a finite value are left out.
 *
 * @param x ascending
 * @param column a column's width, in the unit of x
 */
export function thinColumns(x: ArrayLike<number>, y: ArrayLike<number>, column: number): number[] {
  const rows: number[] = []
  let before = NaN
  let first = -1
  let last = -1
  let low = -1
  let high = -1
  const close = () => {
    if (first < 0) return
    const [early, late] = low < high ? [low, high] : [high, low]
    if (rows.length === 0 && first !== early) rows.push(first)
    rows.push(early)
    if (late !== early) rows.push(late)
  }
  for (let row = 0; row < y.length; row++) {
    const value = y[row]!
    if (!Number.isFinite(value)) continue
    const here = Math.floor(x[row]! / column)
    if (here !== before) {
      close()
      before = here
      first = low = high = row
    } else if (value < y[low]!) low = row
    else if (value > y[high]!) high = row
    last = row
  }
  close()
  if (last >= 0 && rows.at(-1) !== last) rows.push(last)
  return rows
}

/**
 * The rows of a curve that goes anywhere: each that is more than a cell away from the one kept before it, and the last.
 *
 * @param width of a cell, in the unit of x
 * @param height of a cell, in the unit of y
 */
export function thinPath(
  x: ArrayLike<number>,
  y: ArrayLike<number>,
  width: number,
  height: number,
): number[] {
  const rows: number[] = []
  let kept = -1
  let last = -1
  for (let row = 0; row < y.length; row++) {
    const near =
      kept >= 0 && Math.abs(x[row]! - x[kept]!) <= width && Math.abs(y[row]! - y[kept]!) <= height
    if (!Number.isFinite(x[row]!) || !Number.isFinite(y[row]!)) continue
    last = row
    if (near) continue
    rows.push(row)
    kept = row
  }
  if (last !== kept) rows.push(last)
  return rows
}
