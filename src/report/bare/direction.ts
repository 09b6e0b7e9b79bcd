/** To which side a block with that speed and that drive slides; 0: it stays. `hold` is what static friction can hold. */
export function direction(v: number, drive: number, hold: number): -1 | 0 | 1 {
  if (v !== 0) return v > 0 ? 1 : -1
  return Math.abs(drive) <= hold ? 0 : drive > 0 ? 1 : -1
}
