/** A vector in the plane, x to the right and y upwards. */
export interface Vector {
  x: number
  y: number
}

export const zero: Vector = { x: 0, y: 0 }

export function plus(...vectors: Vector[]): Vector {
  return vectors.reduce((sum, { x, y }) => ({ x: sum.x + x, y: sum.y + y }))
}

export function times(factor: number, { x, y }: Vector): Vector {
  return { x: factor * x, y: factor * y }
}

export function dot(a: Vector, b: Vector): number {
  return a.x * b.x + a.y * b.y
}

export function length({ x, y }: Vector): number {
  return Math.sqrt(x * x + y * y)
}
