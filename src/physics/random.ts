/**
 * Seeded random whole numbers, uniform in 0 … 2³² − 1: a Weyl sequence through the finalizer of MurmurHash3.
 * Only 32-bit integer operations, so every engine draws the same numbers.
 */
export class Random {
  private state: number

  /**
   * `seed`: a whole number in 0 … 2³² − 1, mixed so that two seeds a Weyl step apart do not give the same sequence,
   * shifted.
   */
  constructor(seed: number) {
    this.state = mixed(seed)
  }

  next(): number {
    this.state = (this.state + 0x9e3779b9) | 0
    return mixed(this.state) >>> 0
  }
}

function mixed(bits: number): number {
  bits = Math.imul(bits ^ (bits >>> 16), 0x85ebca6b)
  bits = Math.imul(bits ^ (bits >>> 13), 0xc2b2ae35)
  return bits ^ (bits >>> 16)
}
