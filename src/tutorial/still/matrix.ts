/** As a canvas has it: x′ = a x + c y + e, y′ = b x + d y + f. */
export interface Matrix {
  readonly a: number
  readonly b: number
  readonly c: number
  readonly d: number
  readonly e: number
  readonly f: number
}

export const identity: Matrix = { a: 1, b: 0, c: 0, d: 1, e: 0, f: 0 }

/** First the second, then the first. */
export function product(m: Matrix, n: Matrix): Matrix {
  return {
    a: m.a * n.a + m.c * n.b,
    b: m.b * n.a + m.d * n.b,
    c: m.a * n.c + m.c * n.d,
    d: m.b * n.c + m.d * n.d,
    e: m.a * n.e + m.c * n.f + m.e,
    f: m.b * n.e + m.d * n.f + m.f,
  }
}

export function applied({ a, b, c, d, e, f }: Matrix, x: number, y: number): [number, number] {
  return [a * x + c * y + e, b * x + d * y + f]
}

/** How much longer it makes a line; pictures only ever turn, move and enlarge. */
export function magnification({ a, b }: Matrix): number {
  return Math.hypot(a, b)
}

/** What the picture needs of the browser's own matrix. */
export class SvgMatrix implements Matrix {
  readonly a: number
  readonly b: number
  readonly c: number
  readonly d: number
  readonly e: number
  readonly f: number

  constructor([a = 1, b = 0, c = 0, d = 1, e = 0, f = 0]: readonly number[] = []) {
    ;[this.a, this.b, this.c, this.d, this.e, this.f] = [a, b, c, d, e, f]
  }

  translate(x: number, y: number): SvgMatrix {
    const { a, b, c, d, e, f } = product(this, { ...identity, e: x, f: y })
    return new SvgMatrix([a, b, c, d, e, f])
  }
}
